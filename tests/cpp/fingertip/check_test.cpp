// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check() must see every way in which a plan can lie: each test breaks one promise of a good plan.
// The plans are made by hand, without any search.
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "graspless/fingertip/fingertip.hpp"
#include "graspless/mechanics/contact_patch.hpp"

namespace graspless::fingertip {
namespace {

using mechanics::Vector6d;

/// The paper's cuboid (1 unit = 1 m) on the floor, slid by two fingers along x.
Problem sliding_problem() {
  const Eigen::Isometry3d X_WO(Eigen::Translation3d(0, 0, 2.5));
  Fingers fingers;
  fingers.radius = 1;
  return {Object::box("cuboid", {5, 10, 5}, 1), fingers, {Plane{}}, {0.5, 0.5},
          slide_path(X_WO, {1, 0, 0}, 2),       {}};
}

FingerState touching(const Eigen::Vector3d& p_OC, const Eigen::Vector3d& n_O) {
  FingerState finger;
  finger.p_OC = p_OC;
  finger.n_O = n_O;
  return finger;
}

FingerState on_top(double x, double y) { return touching({x, y, 2.5}, {0, 0, -1}); }
FingerState behind(double y, double z) { return touching({-2.5, y, z}, {1, 0, 0}); }

/// Builds plans out of public mechanics alone.
class Builder {
 public:
  Builder(const Problem& problem, const Options& options) : problem_(problem), options_(options) {}

  Row row(const Eigen::Isometry3d& X_WO, const Vector6d& twist_W, bool at_rest,
          const std::vector<FingerState>& fingers) const {
    const mechanics::ContactSet set = contact_set(X_WO, twist_W, at_rest, fingers);
    const mechanics::ControlModes best =
        mechanics::best_control_modes(set, {}, options_.disturbance_directions);
    EXPECT_TRUE(best.found);
    const auto nominal =
        mechanics::interior_equilibrium(set, best.modes, best.stability.commanded_forces);
    Row row;
    row.X_WO = X_WO;
    row.fingers = fingers;
    row.stability = best.stability.z;
    row.nominal_margin = nominal->margin;
    row.compliant_stability = mechanics::compliant_stability(
        set, best.modes, *nominal, options_.compliance, options_.disturbance_directions);
    Eigen::Index k = 0;
    for (FingerState& finger : row.fingers) {
      if (!finger.touches) continue;
      finger.mode = best.modes[static_cast<std::size_t>(k)];
      finger.commanded_force = best.stability.commanded_forces[k];
      finger.nominal_force_O = nominal->finger_forces_O.col(k++);
    }
    return row;
  }

  /// Along x, straight; every fingertip goes as far as the object.
  Segment slide(const std::vector<Eigen::Isometry3d>& X_WO, const std::vector<FingerState>& fingers,
                double& cost) const {
    Segment slide{"slide", X_WO, {}, -1};
    for (std::size_t k = 0; k + 1 < X_WO.size(); ++k) {
      const Eigen::Vector3d step = X_WO[k + 1].translation() - X_WO[k].translation();
      Vector6d twist = Vector6d::Zero();
      twist.head<3>() = step;
      for (int j = 0; j < options_.samples_per_arc; ++j) {
        const Eigen::Translation3d part((j + 0.5) / options_.samples_per_arc * step);
        slide.rows.push_back(row(part * X_WO[k], twist, false, fingers));
        cost += (1 + options_.stability_weight / slide.rows.back().stability) * step.norm() /
                options_.samples_per_arc;
      }
    }
    return slide;
  }

  Segment regrasp(const Eigen::Isometry3d& X_WO, const Vector6d& twist_W, int finger,
                  std::vector<FingerState> fingers) const {
    fingers[static_cast<std::size_t>(finger)].touches = false;
    return {"regrasp", {X_WO}, {row(X_WO, twist_W, true, fingers)}, finger};
  }

  static void finish(Plan& plan) {
    plan.status = Status::solved;
    plan.lower_bound = plan.cost;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < plan.segments.size(); ++s) {
      for (std::size_t r = 0; r < plan.segments[s].rows.size(); ++r) {
        if (plan.segments[s].rows[r].stability >= least) continue;
        least = plan.segments[s].rows[r].stability;
        plan.weakest_segment = static_cast<int>(s);
        plan.weakest_row = static_cast<int>(r);
      }
    }
  }

 private:
  mechanics::ContactSet contact_set(const Eigen::Isometry3d& X_WO, const Vector6d& twist_W,
                                    bool at_rest, const std::vector<FingerState>& fingers) const {
    const Object& object = problem_.object;
    std::vector<mechanics::Plane> planes;
    for (const Plane& plane : problem_.planes) {
      planes.push_back({plane.name, plane.n_W, plane.offset, problem_.friction.lower});
    }
    mechanics::ContactSet set;
    set.contacts = mechanics::contact_patches(object.hull(), object.com(), planes,
                                              {X_WO, twist_W, at_rest}, 1e-6)
                       .contacts;
    for (const FingerState& finger : fingers) {
      if (!finger.touches) continue;
      set.fingers.push_back({finger.p_OC, finger.n_O, problem_.fingers.friction.lower,
                             problem_.fingers.max_normal_force, Eigen::Vector3d::Zero()});
    }
    set.com_O = object.com();
    set.known_wrench_O =
        mechanics::gravity_wrench(object.mass(), X_WO.linear().transpose() * problem_.gravity_W);
    set.wrench_scale = mechanics::wrench_scale(object.mass(), object.inertia());
    set.cone_edges = options_.cone_edges;
    return set;
  }

  const Problem& problem_;
  const Options& options_;
};

class FingertipCheck : public ::testing::Test {
 protected:
  FingertipCheck() : problem_(sliding_problem()) {
    X_WO_ = std::get<Path>(problem_.motion).X_WO;
    const Builder builder(problem_, options_);
    plan_.segments = {builder.slide(X_WO_, {on_top(0, 0), behind(0, 0)}, plan_.cost)};
    Builder::finish(plan_);
  }

  /// Slides, moves the finger behind to one side, and slides on.
  Plan with_regrasp() const {
    const Builder builder(problem_, options_);
    const std::vector<FingerState> first = {on_top(0, 0), behind(0, 0)},
                                   second = {on_top(0, 0), behind(0.5, 0)};
    Vector6d twist = Vector6d::Zero();
    twist.x() = 1;
    Plan plan;
    plan.segments.push_back(builder.slide({X_WO_[0], X_WO_[1]}, first, plan.cost));
    plan.segments.push_back(builder.regrasp(X_WO_[1], twist, 1, first));
    plan.segments.push_back(builder.slide({X_WO_[1], X_WO_[2]}, second, plan.cost));
    plan.cost += options_.regrasp_cost;
    plan.regrasps = 1;
    Builder::finish(plan);
    return plan;
  }

  std::string faults(const Problem& problem, const Plan& plan, const Options& options) const {
    std::string all;
    for (const std::string& fault : check(problem, plan, options)) all += fault + "\n";
    return all;
  }
  void expect_fault(const std::string& words) const {
    const std::string all = faults(problem_, plan_, options_);
    EXPECT_NE(all.find(words), std::string::npos) << "faults found:\n" << all;
  }
  Row& row(std::size_t r, std::size_t s = 0) { return plan_.segments[s].rows[r]; }
  std::size_t force_finger(std::size_t r) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (row(r).fingers[i].mode == FingerMode::force) return i;
    }
    throw std::logic_error("no finger in force control");
  }

  Problem problem_;
  Options options_;
  std::vector<Eigen::Isometry3d> X_WO_;
  Plan plan_;
};

TEST_F(FingertipCheck, AGoodPlanHolds) { EXPECT_EQ(faults(problem_, plan_, options_), ""); }

TEST_F(FingertipCheck, AGoodPlanWithARegraspHolds) {
  EXPECT_EQ(faults(problem_, with_regrasp(), options_), "");
}

TEST_F(FingertipCheck, APlanThatWasNotFound) {
  plan_.status = Status::unstable;
  expect_fault("not solved");
}

TEST_F(FingertipCheck, NoSegments) {
  plan_.segments.clear();
  expect_fault("has no segments");
}

TEST_F(FingertipCheck, AMissingRow) {
  plan_.segments[0].rows.pop_back();
  expect_fault("segment 0 (slide): has 5 rows, not 6");
}

TEST_F(FingertipCheck, AMissingFinger) {
  row(1).fingers.pop_back();
  expect_fault("segment 0 (slide), row 1: has 1 fingers, not 2");
}

TEST_F(FingertipCheck, AValueThatIsNotFinite) {
  row(3).fingers[1].nominal_force_O.y() = std::numeric_limits<double>::quiet_NaN();
  expect_fault("row 3: has a value that is not finite");
}

TEST_F(FingertipCheck, APoseThatIsNotRigid) {
  plan_.segments[0].X_WO[1].linear() *= 1.01;
  expect_fault("pose 1 is not rigid");
}

TEST_F(FingertipCheck, AnotherMotion) {
  plan_.segments[0].X_WO[1].translation().x() += 0.001;
  expect_fault("pose 1 is not the path's");
}

TEST_F(FingertipCheck, AShorterMotion) {
  plan_.segments[0].X_WO.pop_back();
  plan_.segments[0].rows.resize(3);
  expect_fault("passes 2 poses, not the path's 3");
}

TEST_F(FingertipCheck, ARowOffTheMotion) {
  row(4).X_WO.translation().x() += 0.001;
  expect_fault("row 4: pose: not where the motion has the object");
}

TEST_F(FingertipCheck, AGapBetweenSegments) {
  plan_ = with_regrasp();
  plan_.segments[2].X_WO[0].translation().x() += 0.001;
  expect_fault("segment 2 (slide): does not begin where the last one ended");
}

TEST_F(FingertipCheck, AContactOffTheSurface) {
  for (Row& r : plan_.segments[0].rows) r.fingers[0].p_OC.z() += 0.01;
  expect_fault("finger 0: contact: not on the object's surface");
}

TEST_F(FingertipCheck, AnotherNormal) {
  for (Row& r : plan_.segments[0].rows) r.fingers[0].n_O *= -1;
  expect_fault("finger 0: contact: not on the object's surface");
}

TEST_F(FingertipCheck, AFingerThatSlips) {
  row(2).fingers[1].p_OC.y() += 0.01;
  expect_fault("row 2: finger 1 has moved without a regrasp");
}

TEST_F(FingertipCheck, SwappedFingers) {
  plan_ = with_regrasp();
  for (Row& r : plan_.segments[2].rows) std::swap(r.fingers[0], r.fingers[1]);
  expect_fault("segment 2 (slide), row 0: finger 0 has moved without a regrasp");
}

TEST_F(FingertipCheck, ASkippedRegrasp) {
  plan_ = with_regrasp();
  plan_.segments.erase(plan_.segments.begin() + 1);
  plan_.regrasps = 0;
  plan_.cost -= options_.regrasp_cost;
  expect_fault("segment 1 (slide), row 0: finger 1 has moved without a regrasp");
}

TEST_F(FingertipCheck, TheWrongFingerRegrasps) {
  plan_ = with_regrasp();
  plan_.segments[1].finger = 0;
  expect_fault("segment 1 (regrasp), row 0: finger 0 touches while it regrasps");
}

TEST_F(FingertipCheck, AFingerInTheAir) {
  row(2).fingers[0].touches = false;
  expect_fault("row 2: finger 0 does not touch");
}

TEST_F(FingertipCheck, ARegraspAtTheEnd) {
  plan_ = with_regrasp();
  plan_.segments.pop_back();
  expect_fault("a plan begins and ends with all fingers on the object");
}

TEST_F(FingertipCheck, AnObjectThatDropsWhileAFingerRegrasps) {
  // One finger on a pile of weights: no disturbance is left that it withstands.
  plan_ = with_regrasp();
  options_.min_stability = row(0, 1).stability + 0.1;
  expect_fault("segment 1 (regrasp), row 0: stability: ");
}

TEST_F(FingertipCheck, OtherModes) {
  const std::size_t i = force_finger(1);
  row(1).fingers[i].mode = FingerMode::position;
  row(1).fingers[i].commanded_force = 0;
  expect_fault("row 1: modes: the fingers can jam the object");
}

TEST_F(FingertipCheck, ACommandedForceBeyondTheLimit) {
  row(1).fingers[force_finger(1)].commanded_force = 10.1;
  expect_fault("commanded force 10.1 N is not within 0 and 10");
}

TEST_F(FingertipCheck, ACommandedForceInPositionControl) {
  row(1).fingers[1 - force_finger(1)].commanded_force = 1;
  expect_fault("commanded force 1 N is not within 0 and 0");
}

TEST_F(FingertipCheck, AnotherCommandedForce) {
  row(1).fingers[force_finger(1)].commanded_force *= 0.9;
  expect_fault("row 1: stability: ");
  expect_fault("N along the normal, commanded");
}

TEST_F(FingertipCheck, APromiseOfMoreStability) {
  row(5).stability *= 1 + 1e-5;
  expect_fault("row 5: stability: ");
}

TEST_F(FingertipCheck, LessThanIsNeeded) {
  options_.min_stability = row(0).stability * 1.01;
  expect_fault("(needed ");
}

TEST_F(FingertipCheck, APromiseOfMoreCompliantStability) {
  row(5).compliant_stability += 0.01;
  expect_fault("row 5: compliant stability: ");
}

TEST_F(FingertipCheck, NominalForcesOutOfBalance) {
  row(2).fingers[1].nominal_force_O.y() += 0.01;
  row(2).fingers[0].nominal_force_O.x() -= 0.01;
  expect_fault("row 2: nominal forces: ");
}

TEST_F(FingertipCheck, NominalForcesOutOfTheirCones) {
  for (FingerState& finger : row(2).fingers) {
    finger.nominal_force_O -= finger.nominal_force_O.dot(finger.n_O) * 1.2 * finger.n_O;
  }
  expect_fault("row 2: nominal forces: ");
}

TEST_F(FingertipCheck, APromiseOfMoreMargin) {
  row(2).nominal_margin += 0.001;
  expect_fault("row 2: nominal margin: ");
}

TEST_F(FingertipCheck, AFingertipInAWall) {
  problem_.planes.push_back({"wall", {1, 0, 0}, -4.4});
  expect_fault("segment 0 (slide), pose 0: finger 1 reaches 0.1 m into plane 'wall'");
}

TEST_F(FingertipCheck, AFingertipInAnObstacle) {
  problem_.obstacles = {{"shelf",
                         {{geometry::Box{{0.5, 0.5, 0.5}}, Eigen::Isometry3d::Identity()}},
                         Eigen::Isometry3d(Eigen::Translation3d(1.0, 0, 7.1))}};
  expect_fault("segment 0 (slide), pose 2: finger 0 touches obstacle 'shelf'");
  expect_fault("segment 0 (slide), row 5: finger 0 touches obstacle 'shelf'");
}

TEST_F(FingertipCheck, AnObstacleInTheObjectsWay) {
  problem_.obstacles = {{"stone",
                         {{geometry::Box{{0.2, 0.2, 0.2}}, Eigen::Isometry3d::Identity()}},
                         Eigen::Isometry3d(Eigen::Translation3d(3.45, 4, 0.1))}};
  expect_fault("pose 2: obstacle 'stone' touches the object");
}

TEST_F(FingertipCheck, FingertipsThatOverlap) {
  for (Row& r : plan_.segments[0].rows) {
    r.fingers[0].p_OC.x() = -2.4;
    r.fingers[1].p_OC.z() = 2.4;
  }
  expect_fault("finger 1 overlaps finger 0");
}

TEST_F(FingertipCheck, AWallInTheObject) {
  problem_.planes.push_back({"wall", {-1, 0, 0}, -3.2});  // the object ends at x = 3.5
  const std::vector<Eigen::Isometry3d> path = X_WO_;
  try {  // validate() may see it first: then nothing is left to check
    expect_fault("wall");
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("wall"), std::string::npos) << error.what();
  }
}

TEST_F(FingertipCheck, AnotherCost) {
  plan_.cost *= 1 + 1e-7;
  expect_fault("plan: cost: ");
}

TEST_F(FingertipCheck, ALowerBoundAboveTheCost) {
  plan_.lower_bound *= 1.001;
  expect_fault("plan: lower bound ");
}

TEST_F(FingertipCheck, AnotherNumberOfRegrasps) {
  plan_.regrasps = 1;
  expect_fault("says 1 regrasps, has 0");
}

TEST_F(FingertipCheck, AnotherWeakestRow) {
  plan_ = with_regrasp();
  const bool first = plan_.weakest_segment == 0;
  plan_.weakest_segment = first ? 1 : 0;
  plan_.weakest_row = 0;
  expect_fault("is not the weakest");
}

TEST_F(FingertipCheck, FrictionThatMayBeLess) {
  problem_.friction = {0.5, 20};
  expect_fault("friction: fails at ");
}

TEST_F(FingertipCheck, AStepThatIsTooLong) {
  problem_.motion = Goal{X_WO_.front(), X_WO_.back(), 0.4, 0.1, 0};
  expect_fault("the step to pose 1 turns by ");
}

TEST_F(FingertipCheck, SmallStepsToAGoal) {
  problem_.motion = Goal{X_WO_.front(), X_WO_.back(), 0.5, 0.1, 0};
  EXPECT_EQ(faults(problem_, plan_, options_), "");
}

TEST_F(FingertipCheck, StepsOnALattice) {
  problem_.motion = Lattice{X_WO_.front(), X_WO_.back(), {0, -1, -1}, {1, 1, 1}, {3, 3, 3}};
  EXPECT_EQ(faults(problem_, plan_, options_), "");
}

TEST_F(FingertipCheck, AStepOverALatticesPose) {
  problem_.motion = Lattice{X_WO_.front(), X_WO_.back(), {0, -1, -1}, {1, 1, 1}, {5, 3, 3}};
  expect_fault("pose 1 is no neighbour of the one before");
}

TEST_F(FingertipCheck, APoseBetweenALatticesPoses) {
  problem_.motion = Lattice{X_WO_.front(), X_WO_.back(), {0, -1, -1}, {1, 1, 1}, {4, 3, 3}};
  expect_fault("pose 1 is not on the lattice");
}

}  // namespace
}  // namespace graspless::fingertip
