// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "graspless/fingertip/fingertip.hpp"
#include "graspless/mechanics/contact_patch.hpp"
#include "graspless/mechanics/withstands.hpp"

#include "complaint.hpp"

/// Plans made by hand, without any search, for check() to look at.
namespace graspless::fingertip {

using mechanics::Vector6d;

/// The paper's cuboid (1 unit = 1 m) on the floor, slid by two fingers along x.
inline Problem sliding_problem() {
  const Eigen::Isometry3d X_WO(Eigen::Translation3d(0, 0, 2.5));
  Fingers fingers;
  fingers.radius = 1;
  return {Object::box("cuboid", {5, 10, 5}, 1), fingers, {Plane{}}, {0.5, 0.5},
          slide_path(X_WO, {1, 0, 0}, 2),       {}};
}

inline FingerState touching(const Eigen::Vector3d& p_OC, const Eigen::Vector3d& n_O) {
  FingerState finger;
  finger.p_OC = p_OC;
  finger.n_O = n_O;
  return finger;
}

inline FingerState on_top(double x, double y) { return touching({x, y, 2.5}, {0, 0, -1}); }
inline FingerState behind(double y, double z) { return touching({-2.5, y, z}, {1, 0, 0}); }

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
        mechanics::compliant_equilibrium(set, best.modes, best.stability.commanded_forces,
                                         options_.compliance, options_.disturbance_directions);
    Row row;
    row.X_WO = X_WO;
    row.fingers = fingers;
    row.stability = best.stability.z;
    row.nominal_margin = nominal->margin;
    row.compliant_stability = mechanics::compliant_stability(
        set, best.modes, *nominal, options_.compliance, options_.disturbance_directions);
    const mechanics::Promise promise = mechanics::promise(
        set, best.modes, *nominal, options_.compliance,
        {problem_.object.hull(), options_.max_yield}, options_.disturbance_directions);
    row.withstands = promise.withstands;
    row.place_tolerance = promise.place_tolerance;
    Eigen::Index k = 0;
    for (FingerState& finger : row.fingers) {
      if (!finger.touches) continue;
      finger.mode = best.modes[k];
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
      // Nothing but the pose changes along a slide.
      if (slide.rows.empty()) slide.rows = {row(X_WO[k], twist, false, fingers)};
      for (int j = 0; j < options_.samples_per_arc; ++j) {
        const Eigen::Translation3d part((j + 0.5) / options_.samples_per_arc * step);
        if (k + static_cast<std::size_t>(j) > 0) slide.rows.push_back(slide.rows.front());
        slide.rows.back().X_WO = part * X_WO[k];
        cost += (1 + options_.stability_weight / slide.rows.back().stability) * step.norm() /
                options_.samples_per_arc;
      }
    }
    return slide;
  }

  Segment regrasp(const Eigen::Isometry3d& X_WO, const Vector6d& twist_W, int finger,
                  std::vector<FingerState> fingers) const {
    fingers[finger].touches = false;
    return {"regrasp", {X_WO}, {row(X_WO, twist_W, true, fingers)}, finger};
  }

  static void finish(Plan& plan) {
    plan.status = Status::solved;
    plan.lower_bound = plan.cost;
    double least = std::numeric_limits<double>::infinity();
    plan.withstands = plan.place_tolerance = least;
    for (std::size_t s = 0; s < plan.segments.size(); ++s) {
      for (std::size_t r = 0; r < plan.segments[s].rows.size(); ++r) {
        const Row& row = plan.segments[s].rows[r];
        plan.withstands = std::min(plan.withstands, row.withstands);
        plan.place_tolerance = std::min(plan.place_tolerance, row.place_tolerance);
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
      planes.push_back(
          {plane.name, plane.n_W, plane.offset, plane.friction.value_or(problem_.friction).lower});
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

/// A plan to break.
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
    return joined(check(problem, plan, options));
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

}  // namespace graspless::fingertip
