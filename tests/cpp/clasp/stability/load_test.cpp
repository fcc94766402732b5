// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/load.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include "graspless/clasp/clasp.hpp"

#include "clasp/hands.hpp"
#include "clasp/parallel_gripper.hpp"
#include "clasp/ring_problem.hpp"
#include "complaint.hpp"
#include "paths.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// Effort of the hand closed to a gap on each side of the bar [m].
double effort(const Problem& problem, double torque, double gap = 0.0015) {
  VectorXd q = problem.q_start;
  q[problem.robot.joint("slide_left")] = 0.01 + gap;
  return LoadTester(problem).effort(q, {0, 0, 1.09}, 0.06, 0, torque).effort;
}

TEST(LoadTester, ABarThatTurnsPushesTheFingersApartAtTheirEdges) {
  const Problem problem = ring_in_gripper(0.02);
  // The edges are 20 mm apart. Each finger opens by the same length, against 50 N. Before the bar
  // reaches the edges, it touches further inside, where its lever is shorter.
  const double expected = kSudden * 2 * 0.2 / 0.02 / 50;
  EXPECT_NEAR(effort(problem, 0.2), expected, 0.2 * expected);
  EXPECT_NEAR(effort(problem, 0.1), expected / 2, 0.1 * expected);
  EXPECT_GT(effort(problem, 1), 1);
  EXPECT_EQ(effort(problem, 0), 0);
}

TEST(LoadTester, AnObjectThatLeavesTheHandLoadsNothing) {
  Problem problem = ring_in_gripper(0.02);
  problem.X_WO.translation().z() += 0.15;
  EXPECT_EQ(effort(problem, 1), 0);
}

TEST(LoadTester, AForceReachesFingersFarFromTheBar) {
  const Problem problem = ring_in_gripper(0.02);
  VectorXd q = problem.q_start;
  for (const double gap : {0.0015, 0.0195}) {
    q[problem.robot.joint("slide_left")] = 0.01 + gap;
    const double pushed = LoadTester(problem).effort(q, {0, 0, 1.09}, 0.06, 20, 0).effort;
    EXPECT_GE(pushed, kSudden * 20 / 50 - 1e-9) << gap;
  }
}

TEST(LoadTester, FingersFarFromTheBarAreReachedAllTheSame) {
  const Problem problem = ring_in_gripper(0.02);
  for (const double gap : {0.004, 0.008, 0.012, 0.016, 0.0195}) {
    EXPECT_GT(effort(problem, 1, gap), 0.5) << gap;
  }
}

TEST(LoadTester, EffortIsInverseToTheLimitsAndProportionalToTheLoad) {
  Problem problem = ring_in_gripper(0.02);
  VectorXd q = problem.q_start;
  q[problem.robot.joint("slide_left")] = 0.0115;
  const auto of = [&](double force, double torque) {
    return LoadTester(problem).effort(q, {0, 0, 1.09}, 0.06, force, torque);
  };
  const LoadEffort weak = of(2, 0.1);
  EXPECT_EQ(weak.joint, problem.robot.joint("slide_left"));
  EXPECT_GT(weak.effort, 0);
  EXPECT_NEAR(of(6, 0.3).effort, 3 * weak.effort, 1e-6 * weak.effort);
  // Directions that are added never make the hand stronger.
  EXPECT_GE(weak.effort, of(2, 0).effort - 1e-9);
  for (const auto& [limit, share] : {std::pair{"5", 10.0}, std::pair{"0.5", 100.0}}) {
    problem.robot = parallel_gripper(limit);
    EXPECT_NEAR(of(2, 0.1).effort, share * weak.effort, 0.05 * share * weak.effort);
  }
  problem.robot = parallel_gripper("100");
  EXPECT_NEAR(of(2, 0.1).effort, weak.effort / 2, 0.05 * weak.effort);
}

TEST(LoadTester, EndsAtTheFirstLoadThatIsTooLarge) {
  const Problem problem = ring_in_gripper(0.02);
  VectorXd q = problem.q_start;
  q[problem.robot.joint("slide_left")] = 0.0115;
  const LoadTester tester(problem);
  const double most = tester.effort(q, {0, 0, 1.09}, 0.06, 0, 0.2).effort;
  EXPECT_EQ(tester.effort(q, {0, 0, 1.09}, 0.06, 0, 0.2, most).effort, most);
  const double first = tester.effort(q, {0, 0, 1.09}, 0.06, 0, 0.2, most / 4).effort;
  EXPECT_GT(first, most / 4);
  EXPECT_LE(first, most);
  Crew crew(4);
  for (const double enough : {1e9, most, most / 2, most / 4, most / 8}) {
    const LoadEffort alone = tester.effort(q, {0, 0, 1.09}, 0.06, 0, 0.2, enough);
    const LoadEffort together = tester.effort(q, {0, 0, 1.09}, 0.06, 0, 0.2, enough, &crew);
    EXPECT_EQ(together.effort, alone.effort);
    EXPECT_EQ(together.joint, alone.joint);
  }
}

TEST(TestStability, TellsWhatTheMotorsOfEveryHandWithstand) {
  for (const std::string name : {"kr5_sdh", "kr5_dlr"}) {
    const Problem problem = ring_problem(name);
    planning::Budget budget;
    budget.seed = 2;
    budget.iterations = 200;
    const Plan plan = clasp::plan(problem, {}, budget);
    ASSERT_TRUE(plan) << name << ": " << plan.reason;
    EXPECT_GT(plan.stability.withstands, 0);
    EXPECT_LT(plan.stability.withstands, 1e6);
    const auto& hand = problem.robot.group(problem.hand.hand);
    const int first = problem.robot.joint(plan.stability.opens_first);
    EXPECT_TRUE(std::count(hand.begin(), hand.end(), first));
    // The force is that of the hand, not of the load that is asked for.
    StabilityOptions stronger;
    stronger.force *= 4;
    stronger.torque *= 4;
    const VectorXd& q = plan.segments.back().positions.back();
    const Stability found = test_stability(problem, q, plan.loop, stronger);
    EXPECT_NEAR(found.withstands, plan.stability.withstands, 1e-6 * found.withstands);
    EXPECT_EQ(found.opens_first, plan.stability.opens_first);
    EXPECT_TRUE(check(problem, plan).empty());
    Plan spoilt = plan;
    spoilt.stability.withstands *= 1.01;
    EXPECT_FALSE(check(problem, spoilt).empty());
    spoilt = plan;
    spoilt.stability.opens_first = "another";
    EXPECT_FALSE(check(problem, spoilt).empty());
  }
}

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(TestStability, AJointWithoutALimitNeverGivesWayAndIsNamed) {
  Problem problem = ring_problem();
  robot::Robot::Options options;
  options.srdf = text_of(urdf_file("kr5_sdh.srdf"));
  std::string urdf = text_of(urdf_file("kr5_sdh.urdf"));
  for (const std::string limit : {"effort=\"2.1\"", "effort=\"1.4\""}) {
    for (auto at = urdf.find(limit); at != std::string::npos; at = urdf.find(limit))
      urdf.replace(at, limit.size(), "effort=\"0\"");
  }
  problem.robot = robot::Robot::from_urdf(urdf, options);
  planning::Budget budget;
  budget.seed = 2;
  budget.iterations = 200;
  const Plan plan = clasp::plan(problem, {}, budget);
  ASSERT_TRUE(plan) << plan.reason;
  EXPECT_EQ(plan.stability.withstands, 1e6);
  EXPECT_EQ(plan.stability.opens_first, "");
  ASSERT_EQ(plan.warnings.size(), 6U);
  EXPECT_NE(plan.warnings[0].find("has no effort limit above 0"), std::string::npos);
}

TEST(StabilityOptions, ATorqueNeedsAForce) {
  StabilityOptions options;
  options.force = 0;
  expect_refused([&] { validate(options); }, "stability.force must be above 0");
  options.torque = 0;
  validate(options);
}

TEST(LoadsW, TurnWithThePalm) {
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d::UnitX()).toRotationMatrix();
  const auto upright = loads_W(Eigen::Matrix3d::Identity(), 2, 3), turned = loads_W(R, 2, 3);
  EXPECT_TRUE((turned.topRows<3>() - R * upright.topRows<3>()).isZero(1e-12));
  EXPECT_TRUE((turned.bottomRows<3>() - R * upright.bottomRows<3>()).isZero(1e-12));
  EXPECT_TRUE(upright.topRows<3>().colwise().norm().isApproxToConstant(2));
  EXPECT_TRUE(upright.bottomRows<3>().colwise().norm().isApproxToConstant(3));
}

TEST(RequireEfforts, NamesTheJointWithoutALimit) {
  Problem problem = ring_in_gripper(0.02);
  problem.robot = parallel_gripper("0");
  EXPECT_EQ(problem.robot.max_effort()[problem.robot.joint("slide_left")],
            std::numeric_limits<double>::infinity());
  expect_refused([&] { plan(problem); }, "joint 'slide_left' of the hand has no effort limit");
  expect_refused([&] { test_stability(problem, problem.q_start, 0); }, "slide_left");
  expect_refused([&] { test_pinch(problem, problem.q_start, 0.5); }, "slide_left");
  StabilityOptions none;
  none.force = none.torque = 0;
  EXPECT_EQ(test_stability(problem, problem.q_start, 0, none).withstands, 0);
}

}  // namespace
}  // namespace graspless::clasp
