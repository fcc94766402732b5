// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Planes with friction of their own.
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fingertip/frictions.hpp"
#include "fingertip/model/evaluator.hpp"
#include "fingertip/model/screw.hpp"
#include "fingertip/planner.hpp"

namespace graspless::fingertip {
namespace {

/// The cuboid slides along a wall with its own friction.
Problem slide_along_wall(const std::optional<FrictionInterval>& friction) {
  Problem problem = slide_case(10, 3);
  problem.planes.push_back({"beside", -Eigen::Vector3d::UnitY(), -5, friction});
  return problem;
}

void expect_same(const Plan& a, const Plan& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.statistics.pivots, b.statistics.pivots);
  ASSERT_EQ(a.segments.size(), b.segments.size());
  for (std::size_t s = 0; s < a.segments.size(); ++s) {
    ASSERT_EQ(a.segments[s].rows.size(), b.segments[s].rows.size());
    for (std::size_t r = 0; r < a.segments[s].rows.size(); ++r) {
      const Row &x = a.segments[s].rows[r], &y = b.segments[s].rows[r];
      EXPECT_EQ(x.stability, y.stability);
      EXPECT_EQ(x.compliant_stability, y.compliant_stability);
      EXPECT_EQ(x.fingers[0].nominal_force_O, y.fingers[0].nominal_force_O);
    }
  }
}

TEST(PlaneFriction, ThatOfTheOthersChangesNothing) {
  for (Problem problem : {slide_along_wall(std::nullopt), tumble_case(true, 6)}) {
    const Plan common = plan(problem, five_a_side());
    ASSERT_TRUE(common) << common.reason;
    for (std::size_t i = 0; i < problem.planes.size(); ++i) {
      problem.planes[i].friction = problem.friction;  // one plane, then more, at last all
      expect_same(common, plan(problem, five_a_side()));
    }
  }
}

TEST(PlaneFriction, WhatNoPlaneSharesChangesNothing) {
  Problem problem = slide_along_wall(FrictionInterval{0.3, 0.3});
  problem.planes[0].friction = FrictionInterval{0.5, 0.5};
  const Plan first = plan(problem, five_a_side());
  ASSERT_TRUE(first) << first.reason;
  problem.friction = {2, 2};
  expect_same(first, plan(problem, five_a_side()));
}

/// z of every row by the definition: contacts of geometry, each with the friction of its plane,
/// and Problem (6) by the reference engine.
TEST(PlaneFriction, TheStabilityIsThatOfContactsWithItsFriction) {
  const Options options = five_a_side();
  for (const double friction : {0.0, 0.2, 0.8}) {
    const Problem problem = slide_along_wall(FrictionInterval{friction, friction});
    const Plan found = plan(problem, options);
    ASSERT_TRUE(found) << found.reason;
    EXPECT_EQ(check(problem, found, options), std::vector<std::string>());
    const Segment& segment = found.segments.front();
    const Row& row = segment.rows.front();
    mechanics::ContactSet set;
    mechanics::BodyState state{row.X_WO};
    state.twist_W.x() = 1;
    set.contacts = mechanics::contact_patches(problem.object.hull(), problem.object.com(),
                                              {{"floor", Eigen::Vector3d::UnitZ(), 0, 0.5},
                                               {"beside", -Eigen::Vector3d::UnitY(), -5, friction}},
                                              state, 1e-6)
                       .contacts;
    ASSERT_EQ(set.contacts.size(), 8U);
    set.known_wrench_O = mechanics::gravity_wrench(1, {0, 0, -9.8});
    set.wrench_scale = mechanics::wrench_scale(1, problem.object.inertia());
    std::vector<FingerMode> modes;
    for (const FingerState& finger : row.fingers) {
      set.fingers.push_back({finger.p_OC, finger.n_O, 0.7, 10, Eigen::Vector3d::Zero()});
      modes.push_back(finger.mode);
    }
    const double z = mechanics::max_stability(set, modes, options.disturbance_directions,
                                              mechanics::Engine::reference)
                         .z;
    EXPECT_NEAR(row.stability, z, 1e-7 * z) << friction;
  }
}

/// Contacts that stick only lose by less friction.
TEST(PlaneFriction, LessOfItNeverRaisesTheStabilityAtRest) {
  const Options options = five_a_side();
  const Problem rough = slide_along_wall(FrictionInterval{0.8, 0.8});
  const Locations locations(rough.object, rough.fingers, options);
  int fell = 0;
  for (int l = 0; l < locations.size(); l += 7) {
    for (int k = l + 3; k < locations.size(); k += 11) {
      double last = std::numeric_limits<double>::infinity();
      for (const double friction : {0.8, 0.4, 0.1, 0.0}) {
        const Problem problem = slide_along_wall(FrictionInterval{friction, friction});
        Instants instants(problem, options);
        Evaluator evaluator(instants, locations, options);
        const int rest = instants.add(resting_state(at(0, 0, 2.5), mechanics::Vector6d::Unit(0)));
        const double z = evaluator.stability(rest, with(with(kNoFingers, l), k));
        EXPECT_LE(z, last * (1 + 1e-9)) << l << ", " << k << " at " << friction;
        if (z < 0.99 * last) ++fell;
        last = z;
      }
    }
  }
  EXPECT_GT(fell, 20);
}

TEST(PlaneFriction, VariesOnItsOwn) {
  const Options options = five_a_side();
  Problem problem = slide_along_wall(FrictionInterval{0.1, 0.3});
  problem.friction = {0.45, 0.55};
  const Plan found = plan(problem, options);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(check(problem, found, options), std::vector<std::string>());
  for (const double floor : {0.45, 0.5, 0.55}) {
    for (const double wall : {0.1, 0.2, 0.3}) {
      EXPECT_GE(stability_at(problem, found, options, {floor, wall}, 0.7), 0.5 - 1e-6)
          << floor << ", " << wall;
    }
  }
}

TEST(PlaneFriction, APlanThatFailsNamesThePlane) {
  Problem problem = slide_along_wall(FrictionInterval{0.2, 0.2});
  const Options options = five_a_side();
  const Plan found = plan(problem, options);
  ASSERT_TRUE(found) << found.reason;
  problem.planes[1].friction = FrictionInterval{0.2, 40};
  Instants instants(problem, options);
  const auto failure = find_friction_failure(problem, options, instants, found);
  ASSERT_TRUE(failure);
  ASSERT_EQ(failure->verdict.environment.size(), 2U);
  EXPECT_EQ(failure->verdict.environment[0], 0.5);
  EXPECT_GT(failure->verdict.environment[1], 0.2);
  EXPECT_LT(
      stability_at(problem, found, options, failure->verdict.environment, failure->verdict.fingers),
      options.min_stability);
  Plan none;
  planning::Clock clock{planning::Budget{}};
  plan_over_friction(
      problem, options, instants, clock, [&] { return found; }, none);
  EXPECT_NE(none.reason.find("fails at 0.5 (environment), "), std::string::npos) << none.reason;
  EXPECT_NE(none.reason.find(" (plane 'beside') and 0.7 (fingers)"), std::string::npos)
      << none.reason;
}

TEST(PlaneFriction, CheckSeesAnotherFriction) {
  const Options options = five_a_side();
  Problem problem = slide_along_wall(FrictionInterval{0.2, 0.2});
  const Plan found = plan(problem, options);
  ASSERT_EQ(check(problem, found, options), std::vector<std::string>());
  for (const FrictionInterval other : {FrictionInterval{0.3, 0.3}, {0.1, 0.1}, {0.2, 40}}) {
    problem.planes[1].friction = other;
    EXPECT_FALSE(check(problem, found, options).empty()) << other.lower << ", " << other.upper;
  }
  problem.planes[1].friction.reset();
  EXPECT_FALSE(check(problem, found, options).empty());
}

}  // namespace
}  // namespace graspless::fingertip
