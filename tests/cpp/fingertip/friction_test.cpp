// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Friction as an interval: a plan holds at every coefficient, looked at one by one; where none does
// the reason names a coefficient.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fingertip/frictions.hpp"
#include "fingertip/planner.hpp"

namespace graspless::fingertip {
namespace {

/// A search that looks at one coefficient alone.
Plan planned_at(Problem problem, double environment) {
  problem.friction = {environment, environment};
  return plan(problem, five_a_side());
}

TEST(FindFrictionFailure, NamesACoefficientAtWhichThePlanFails) {
  Problem problem = slide_case(10, 3);
  const Plan found = planned_at(problem, 0.5);
  ASSERT_TRUE(found);
  problem.friction = {0.5, 5};
  const Options options = five_a_side();
  Instants instants(problem, options);
  const auto failure = find_friction_failure(problem, options, instants, found);
  ASSERT_TRUE(failure);
  const std::vector<double> at = failure->verdict.environment;
  ASSERT_EQ(at.size(), 1U);
  EXPECT_GE(at[0], 0.5);
  EXPECT_LE(at[0], 5);
  EXPECT_LT(stability_at(problem, found, options, at, failure->verdict.fingers),
            options.min_stability);
  EXPECT_GE(stability_at(problem, found, options, {0.5}, 0.7), options.min_stability);
}

TEST(FindFrictionFailure, NothingWhereAPlanHolds) {
  Problem problem = slide_case(10, 3);
  const Plan found = planned_at(problem, 0.5);
  ASSERT_TRUE(found);
  problem.friction = {0.499, 0.501};
  const Options options = five_a_side();
  Instants instants(problem, options);
  EXPECT_FALSE(find_friction_failure(problem, options, instants, found));
}

TEST(PlanOverFriction, LooksAtEachCoefficientThatAPlanFailsFor) {
  Problem problem = slide_case(10, 3);
  problem.friction = {0.5, 5};
  const Options options = five_a_side();
  Instants instants(problem, options);
  int searches = 0;
  Plan found;
  const auto search = [&] {
    ++searches;
    return planned_at(problem, 0.5);  // never learns
  };
  planning::Clock clock{planning::Budget{}};
  plan_over_friction(problem, options, instants, clock, search, found);
  EXPECT_EQ(found.status, Status::unstable);
  EXPECT_NE(found.reason.find("the last one found fails at"), std::string::npos) << found.reason;
  EXPECT_GT(searches, 1);
  const Instant& instant = instants[0];
  EXPECT_EQ(instant.environments.size(), static_cast<std::size_t>(searches) + 1);
}

TEST(PlanOverFriction, HoldsAtEveryCoefficient) {
  Problem problem = slide_case(10, 3);
  problem.friction = {0.4, 0.6};
  problem.fingers.friction = {0.6, 0.8};
  const Plan found = plan(problem, five_a_side());
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(check(problem, found, five_a_side()), std::vector<std::string>());
  for (const double environment : {0.4, 0.45, 0.5, 0.55, 0.6}) {
    for (const double fingers : {0.6, 0.8}) {
      EXPECT_GE(stability_at(problem, found, five_a_side(), {environment}, fingers), 0.5 - 1e-6)
          << environment << ", " << fingers;
    }
  }
}

TEST(PlanOverFriction, AnIntervalIsNoCheaperThanItsEnds) {
  Problem problem = slide_case(10, 3);
  problem.friction = {0.4, 0.6};
  const Plan over = plan(problem, five_a_side());
  ASSERT_TRUE(over) << over.reason;
  for (const double friction : {0.4, 0.6}) {
    Problem exact = problem;
    exact.friction = {friction, friction};
    const Plan at_end = plan(exact, five_a_side());
    ASSERT_TRUE(at_end);
    EXPECT_LE(at_end.cost, over.cost * (1 + 1e-9));
  }
}

TEST(PlanOverFriction, AnIntervalWithoutWidthIsExactFriction) {
  Problem problem = slide_case(10, 3);
  const Plan exact = plan(problem, five_a_side());
  ASSERT_TRUE(exact);
  EXPECT_EQ(check(problem, exact, five_a_side()), std::vector<std::string>());
}

TEST(PlanOverFriction, TumblesOverAnInterval) {
  Problem problem = tumble_case(false, 6);
  problem.friction = {0.45, 0.55};
  problem.fingers.friction = {0.65, 0.75};
  const Plan found = plan(problem, five_a_side());
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(check(problem, found, five_a_side()), std::vector<std::string>());
}

TEST(PlanOverFriction, NoPlanForAnInterval) {
  Problem problem = slide_case(5, 3);
  problem.friction = {0.05, 8};
  const Plan found = plan(problem, five_a_side());
  EXPECT_EQ(found.status, Status::unstable);
  EXPECT_FALSE(found.reason.empty());
  EXPECT_TRUE(found.segments.empty());
}

}  // namespace
}  // namespace graspless::fingertip
