// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "fingertip/cases.hpp"
#include "fingertip/meshes.hpp"

namespace graspless::fingertip {
namespace {

const double kNan = std::nan("");

void expect_problem_refused(const std::function<void(Problem&)>& spoil, const std::string& words) {
  Problem problem = tumble_case(false, 6);
  spoil(problem);
  expect_refused([&] { validate(problem); }, words);
  expect_refused([&] { plan(problem); }, words);
}

void expect_options_refused(const std::function<void(Options&)>& spoil, const std::string& words) {
  Options options;
  spoil(options);
  expect_refused([&] { validate(options); }, words);
}

TEST(FingertipValidate, TakesThePapersCases) {
  for (const Case& it : paper_cases()) EXPECT_NO_THROW(validate(it.problem, Options{})) << it.name;
}

TEST(FingertipValidate, RefusesNumbersThatWouldOverflow) {
  expect_problem_refused([](Problem& p) { p.fingers.max_normal_force = 1e300; },
                         "fingers.max_normal_force must lie in [1e-06, 1e+06] N, not 1e+300");
  expect_problem_refused([](Problem& p) { p.gravity_W.z() = -1e300; },
                         "gravity_W must lie in [0, 1000]");
  expect_problem_refused([](Problem& p) { p.friction.upper = 1e300; },
                         "friction.upper must lie in [0, 10000]");
  expect_refused(
      [] {
        Object::box("heavy", {1, 1, 1}, 1e300);
      },
      "mass must lie in [1e-09, 100000] kg, not 1e+300");
  expect_problem_refused(
      [](Problem& p) {
        p.object = Object::box("heavy", {1, 1, 1}, 1e5);
        p.gravity_W.z() = -900;
      },
      "weight of the object, object.mass times gravity_W must lie in [0, 1e+06] N, not 9e+07");
  expect_options_refused([](Options& o) { o.min_stability = 1e300; }, "options.min_stability");
}

TEST(FingertipValidate, RefusesBadNumbers) {
  for (const double bad : {0.0, -1.0, kNan, HUGE_VAL}) {
    expect_problem_refused([&](Problem& p) { p.fingers.radius = bad; }, "fingers.radius");
    expect_problem_refused([&](Problem& p) { p.fingers.max_normal_force = bad; },
                           "fingers.max_normal_force must lie in");
  }
  for (const double bad : {-1.0, kNan, HUGE_VAL}) {
    expect_problem_refused(
        [&](Problem& p) {
          p.fingers.friction = {bad, bad};
        },
        "fingers.friction.");
    expect_problem_refused([&](Problem& p) { p.friction = {bad, bad}; }, "friction.");
  }
  expect_problem_refused([](Problem& p) { p.friction = {0.6, 0.5}; }, "must not exceed");
  for (const double bad : {-1.0, kNan, 2e4}) {
    expect_problem_refused(
        [&](Problem& p) {
          p.planes[1].friction = FrictionInterval{0.5, bad};
        },
        "planes[1] 'behind'.friction.upper must lie in [0, 10000]");
  }
  expect_problem_refused(
      [](Problem& p) {
        p.planes[0].friction = FrictionInterval{0.6, 0.5};
      },
      "planes[0] 'floor'.friction.lower must not exceed planes[0] 'floor'.friction.upper");
  expect_problem_refused(
      [](Problem& p) {
        p.friction = {0.4, 0.6};
        p.planes.resize(7, p.planes[1]);
        for (Plane& plane : p.planes) plane.friction = p.friction;
        p.planes[0].friction.reset();  // that of the problem
      },
      "friction and planes[i].friction must have lower < upper at most 6 times, not 7");
  expect_problem_refused([](Problem& p) { p.fingers.count = 5; }, "fingers.count must be 1 to 4");
  expect_problem_refused([](Problem& p) { p.gravity_W.z() = kNan; }, "gravity_W");
  expect_problem_refused([](Problem& p) { p.planes.clear(); }, "planes");
  expect_problem_refused([](Problem& p) { p.planes[1].n_W *= 2; }, "planes[1] 'behind'.n_W");
  expect_problem_refused([](Problem& p) { p.planes[0].n_W.setZero(); }, "planes[0] 'floor'.n_W");
  expect_problem_refused([](Problem& p) { p.planes[0].offset = kNan; }, "planes[0] 'floor'.offset");
}

TEST(FingertipValidate, RefusesObjectsThatFloatOrPenetrate) {
  expect_problem_refused([](Problem& p) { p.planes[0].offset = -0.5; },
                         "motion.X_WO[0]: the object floats: it is 0.5");
  expect_problem_refused([](Problem& p) { p.planes[0].offset = 0.5; }, "motion.X_WO[0]");
  // The goal in a wall: 10 ahead of the edge is as far as the cuboid reaches.
  expect_problem_refused(
      [](Problem& p) {
        p.planes.push_back({"ahead", -Eigen::Vector3d::UnitX(), -12});
      },
      "plane 'ahead'");
  expect_problem_refused(
      [](Problem& p) {
        p.obstacles.push_back({"post", {{geometry::Box{{1, 1, 4}}, at(9, 0, 2)}}, at(0, 0, 0)});
      },
      "the object touches obstacle post");
}

TEST(FingertipValidate, RefusesMotionsThatContactsCannotFollow) {
  expect_problem_refused([](Problem& p) { p.motion = Path{{at(0, 0, 5)}}; },
                         "must have 2 to 100000 poses");
  expect_problem_refused(
      [](Problem& p) {
        p.motion = Path{{at(0, 0, 5), at(0, 0, 5)}};
      },
      "the same pose");
  // About an axis askew to the edge on the floor: one of the edge's ends would enter the floor.
  expect_problem_refused(
      [](Problem& p) {
        p.motion = turn_path(at(0, 0, 5), {2.5, 2.5, 0}, {0.3, 1, 0}, 0.2, 3);
      },
      "cannot turn about the axis");
  expect_problem_refused(
      [](Problem& p) {
        p.motion = Path{{at(0, 0, 5), at(0, 0, 5.5)}};
      },
      "lifts off every plane");
  expect_problem_refused(
      [](Problem& p) {
        p.motion =
            Path{{at(0, 0, 5), Eigen::AngleAxisd(3.1, Eigen::Vector3d::UnitZ()) * at(0, 0, 5)}};
      },
      "more than 3 rad");
  expect_refused([] { turn_path(at(0, 0, 5), {0, 0, 0}, {0, 0, 1}, 6.2, 2); }, "3 rad at most");
  expect_problem_refused(
      [](Problem& p) {
        Eigen::Isometry3d skewed = at(0, 0, 5);
        skewed.linear() *= 1.1;
        p.motion = Path{{at(0, 0, 5), skewed}};
      },
      "motion.X_WO[1] must be a rigid pose");
}

TEST(FingertipValidate, RefusesLatticesThatMissStartOrGoal) {
  const auto lattice = [](const std::function<void(Lattice&)>& spoil) {
    return [spoil](Problem& p) {
      Lattice l;
      l.X_WO_start = at(0, 0, 5);
      l.X_WO_goal = at(2, 0, 5);
      l.upper = {3, 3, 1};
      l.counts = {4, 4, 5};
      spoil(l);
      p.motion = l;
    };
  };
  Problem good = tumble_case(false);
  lattice([](Lattice&) {})(good);
  EXPECT_NO_THROW(validate(good));
  expect_problem_refused(lattice([](Lattice& l) { l.X_WO_goal = at(2.5, 0, 5); }),
                         "lattice along x: the goal (2.5");
  expect_problem_refused(lattice([](Lattice& l) { l.X_WO_goal = at(0, 4, 5); }),
                         "lattice along y: the goal (4");
  expect_problem_refused(lattice([](Lattice& l) { l.lower.x() = -0.5; }), "the start (0)");
  expect_problem_refused(lattice([](Lattice& l) { l.counts[2] = 0; }), "yaw");
  expect_problem_refused(lattice([](Lattice& l) {
                           l.counts = {100000, 100000, 100000};
                         }),
                         "motion.counts: a lattice may have 1e9 poses");
  expect_problem_refused(lattice([](Lattice& l) { l.upper.y() = kNan; }), "along y");
  expect_problem_refused(lattice([](Lattice& l) { l.X_WO_goal = at(2, 0, 6); }), "floats");
}

TEST(FingertipValidate, RefusesBadGoals) {
  const auto goal = [](const std::function<void(Goal&)>& spoil) {
    return [spoil](Problem& p) {
      Goal g;
      g.X_WO_start = g.X_WO_goal = at(0, 0, 5);
      spoil(g);
      p.motion = g;
    };
  };
  expect_problem_refused(goal([](Goal& g) { g.slide_step = 0; }), "motion.slide_step");
  expect_problem_refused(goal([](Goal& g) { g.turn_step = kNan; }), "motion.turn_step");
  expect_problem_refused(goal([](Goal& g) { g.slide_step = 1e-300; }), "motion.slide_step");
  expect_problem_refused(goal([](Goal& g) { g.turn_step = 1e-6; }), "motion.turn_step: may make");
  expect_problem_refused(goal([](Goal& g) { g.max_tumbles = -1; }), "motion.max_tumbles");
  expect_problem_refused(goal([](Goal& g) { g.X_WO_goal = at(-4, 0, 5); }), "plane 'behind'");
}

TEST(FingertipValidate, RefusesBadOptions) {
  expect_options_refused([](Options& o) { o.locations_per_side = 0; }, "locations_per_side");
  expect_options_refused([](Options& o) { o.location_spacing = kNan; }, "location_spacing");
  expect_options_refused([](Options& o) { o.cone_edges = 2; },
                         "options.cone_edges must lie in [3, 64], not 2");
  expect_options_refused([](Options& o) { o.samples_per_arc = 0; }, "samples_per_arc");
  expect_options_refused([](Options& o) { o.min_stability = 0; }, "min_stability");
  expect_options_refused([](Options& o) { o.regrasp_cost = -1; }, "regrasp_cost");
  expect_options_refused([](Options& o) { o.stability_weight = kNan; }, "stability_weight");
  expect_options_refused([](Options& o) { o.threads = 0; }, "threads");
  expect_options_refused([](Options& o) { o.max_regrasps = -1; }, "max_regrasps");
  expect_options_refused([](Options& o) { o.max_memory = 0; }, "max_memory");
  expect_options_refused([](Options& o) { o.compliance.finger_normal = 0; },
                         "options.compliance.finger_normal must lie in [1e-09, 1e+09] N/m, not 0");
  expect_options_refused([](Options& o) { o.disturbance_directions.col(2) *= 1e30; },
                         "the length of directions[2] is");
  expect_options_refused([](Options& o) { o.disturbance_directions.resize(6, 3); }, "direction");
}

TEST(FingertipPlan, StatesTheMemoryBeforeItIsUsed) {
  Options options;
  options.locations_per_side = 410;  // 10^6 locations
  for (const Search search : {Search::fast, Search::paper, Search::dijkstra}) {
    options.search = search;
    const Plan found = plan(slide_case(10), options);
    EXPECT_EQ(found.status, Status::out_of_memory);
    EXPECT_NE(found.reason.find("MB, more than options.max_memory"), std::string::npos);
  }
}

}  // namespace
}  // namespace graspless::fingertip
