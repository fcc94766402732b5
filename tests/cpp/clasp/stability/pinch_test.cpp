// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/pinch.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "graspless/clasp/clasp.hpp"
#include "graspless/mechanics/stability.hpp"

#include "clasp/center.hpp"
#include "clasp/parallel_gripper.hpp"
#include "clasp/query.hpp"
#include "clasp/ring_problem.hpp"
#include "clasp/search/reachability.hpp"
#include "complaint.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// Closed to a gap of half a millimetre on each side of a ring of 20 mm.
VectorXd closed(const Problem& problem) {
  VectorXd q = problem.q_start;
  q[problem.robot.joint("slide_left")] = 0.0105;
  return q;
}

/// A load that fingers of 12.5 N withstand.
StabilityOptions light() {
  StabilityOptions options;
  options.force = 0.2;
  options.torque = 0.004;
  return options;
}

StabilityOptions no_load() {
  StabilityOptions options;
  options.force = options.torque = 0;
  return options;
}

TEST(TestPinch, FrictionHoldsABarBetweenPadsAndNothingElseDoes) {
  const Problem problem = ring_in_gripper(0.02);
  const VectorXd q = closed(problem);
  EXPECT_FALSE(test_pinch(problem, q, 0, no_load()).holds);
  double last = 0;
  for (const double friction : {0.3, 0.5, 0.8, 1.2}) {
    const Pinch pinch = test_pinch(problem, q, friction, no_load());
    EXPECT_TRUE(pinch.holds) << friction;
    EXPECT_NEAR(pinch.gap, 0.0005, 0.0003);
    EXPECT_GT(pinch.strength, last);
    last = pinch.strength;
  }
  const Pinch open = test_pinch(problem, problem.q_start, 0.5);
  EXPECT_FALSE(open.holds);
  EXPECT_NEAR(open.gap, 0.02, 0.001);
}

TEST(TestPinch, HalfTheEffortLimitPressesOnBothSides) {
  const Problem problem = ring_in_gripper(0.02);
  const VectorXd q = closed(problem);
  StabilityOptions load = light();
  const Pinch pinch = test_pinch(problem, q, 0.5, load);
  EXPECT_NEAR(pinch.press, 12.5, 0.1);  // half of 50 N on one joint that moves two fingers
  EXPECT_EQ(pinch.holds, pinch.load >= 1);
  load.force *= 2;
  load.torque *= 2;
  EXPECT_NEAR(test_pinch(problem, q, 0.5, load).load, pinch.load / 2, 1e-6);
  EXPECT_FALSE(test_pinch(problem, q, 0.5).holds);  // 2.5 N and 0.15 Nm
}

TEST(TestPinch, OneFingerDoesNotHold) {
  const Problem problem = ring_in_gripper(0.02, 0.006);
  VectorXd q = problem.q_start;
  q[problem.robot.joint("slide_left")] = 0.0165;
  const Pinch pinch = test_pinch(problem, q, 1);
  EXPECT_FALSE(pinch.holds);
  EXPECT_NEAR(pinch.gap, 0.0125, 0.001);
}

TEST(TestPinch, StrengthIsThatOfFourPointsOnTheEdgesOfThePads) {
  const Problem problem = ring_in_gripper(0.02);
  const Pinch pinch = test_pinch(problem, closed(problem), 0.5);
  mechanics::ContactSet set;
  for (const double y : {0.01, -0.01}) {
    for (const double x : {0.01, -0.01})
      set.fingers.push_back({{x, y, -0.12}, {0, -100 * y, 0}, 0.5, 0.5, Vector3d::Zero()});
  }
  set.wrench_scale.bottomRightCorner<3, 3>() /= std::hypot(0.12, 0.01);
  set.cone_edges = 8;
  const std::vector modes(4, mechanics::FingerMode::position);
  const auto directions = mechanics::disturbance_directions();
  const double z = mechanics::max_stability(set, modes, directions, mechanics::Engine::reference).z;
  EXPECT_NEAR(pinch.strength, z, 0.15 * z);
  // Brute force: no wrench beyond the support of the forces in any direction.
  std::mt19937_64 rng(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 20000; ++i) {
    mechanics::Vector6d d;
    for (double& value : d) value = normal(rng);
    double support = 0;
    for (const mechanics::Finger& finger : set.fingers) {
      const Eigen::Matrix3Xd cone =
          mechanics::friction_cone(finger.n_O, 0.5, 8, mechanics::tangent(finger.n_O, {0, 0, 0}));
      double most = 0;
      for (Eigen::Index k = 0; k < cone.cols(); ++k) {
        const Vector3d force = 0.5 / cone.col(k).dot(finger.n_O) * cone.col(k);
        mechanics::Vector6d wrench;
        wrench << force, finger.p_OC.cross(force);
        most = std::max(most, d.dot(set.wrench_scale * wrench));
      }
      support += most;
    }
    EXPECT_LE(z * (directions.transpose() * d).maxCoeff(), support + 1e-9);
  }
}

TEST(TestPinch, RefusesOtherHandsAndFrictions) {
  const Problem problem = ring_in_gripper(0.02);
  expect_refused([&] { test_pinch(problem, closed(problem), -1); },
                 "friction must lie in [0, 10], not -1");
  StabilityOptions negative;
  negative.force = -1;
  expect_refused([&] { test_pinch(problem, closed(problem), 1, negative); }, "force");
  const Problem fist = ring_problem();
  expect_refused([&] { test_pinch(fist, fist.q_start, 0.5); }, "one besides the thumb");
}

TEST(Opening, IsTheGapBetweenThePads) {
  const robot::Robot robot = parallel_gripper();
  EXPECT_NEAR(opening(robot, with_palm_corners(hand_without_palm(), robot)), 0.06, 0.0005);
}

planning::Budget cycles(std::int64_t count) {
  planning::Budget budget;
  budget.seconds = std::numeric_limits<double>::infinity();
  budget.iterations = count;
  return budget;
}

TEST(PlanWithAGripper, TouchesBothSidesOfABarBesideTheMiddle) {
  for (const double side : {0.0, 0.012}) {
    const Problem problem = ring_in_gripper(0.02, side, 0.1);
    Options options;
    options.stability = light();
    const Plan found = plan(problem, options, cycles(20));
    ASSERT_TRUE(found) << found.reason;
    EXPECT_TRUE(check(problem, found, options).empty());
    const VectorXd& q = found.segments.back().positions.back();
    EXPECT_LT(test_pinch(problem, q, 0.5).gap, 0.003);
    EXPECT_TRUE(found.stability.secure || found.pinch);
  }
}

/// State of a search, and a place of the ring that the gripper meets askew.
struct Askew {
  explicit Askew(bool turns) : problem(ring_in_gripper(0.02)), clock(cycles(1)), reach{VectorXd()} {
    problem.robot = parallel_gripper("50", turns);
    reach = {problem.q_start = problem.robot.state("open")};
    const Vector3d lowest = problem.X_WO.translation() - 0.12 * Vector3d::UnitZ();
    target_W = {lowest, Eigen::AngleAxisd(0.3, Vector3d::UnitZ()) * Vector3d::UnitX()};
  }
  Problem problem;
  Options options;
  planning::Clock clock;
  geometry::ClaspTarget target_W;
  planning::Path reach;
};

TEST(SquareUp, BringsTheHandleSquareBetweenThePads) {
  Askew askew(true);
  Query query(askew.problem, askew.options, askew.clock, 1);
  const robot::Robot& robot = askew.problem.robot;
  for (const double sign : {1.0, -1.0}) {  // a tangent has no sense
    askew.reach = {askew.problem.q_start};
    askew.target_W.tangent *= sign;
    ASSERT_TRUE(square_up(query, askew.target_W, askew.reach));
    ASSERT_EQ(askew.reach.size(), 2);
    const Eigen::Isometry3d X_WH = robot.pose(robot.frame("palm"), askew.reach.back());
    EXPECT_NEAR(std::abs(X_WH.linear().col(0).dot(askew.target_W.tangent)), 1, 1e-6);
    EXPECT_GT(X_WH.linear().col(0).x(), 0.9);  // by the smaller angle
    const Vector3d tips = X_WH * Vector3d(0, 0, 0.04 + 0.075);
    const Vector3d pads = askew.target_W.point + 0.015 * X_WH.linear().col(2);
    EXPECT_LT((tips - pads).norm(), 1e-5);
    EXPECT_TRUE(query.is_motion_free(askew.reach.front(), askew.reach.back()));
  }
}

TEST(SquareUp, LeavesTheReachOfAnArmThatCannotTurn) {
  Askew askew(false);
  Query query(askew.problem, askew.options, askew.clock, 1);
  EXPECT_FALSE(square_up(query, askew.target_W, askew.reach));
  EXPECT_EQ(askew.reach.size(), 1);
}

TEST(PlanWithAGripper, WithoutFrictionAPinchIsNoClasp) {
  const Problem problem = ring_in_gripper(0.02, 0, 0.1);
  Options options;
  options.stability = light();
  Plan pinched = plan(problem, options, cycles(20));
  ASSERT_TRUE(pinched.pinch);
  options.friction = 0;
  EXPECT_FALSE(plan(problem, options, cycles(20)).pinch);
  EXPECT_FALSE(check(problem, pinched, options).empty());
  options.friction = 0.5;
  EXPECT_TRUE(check(problem, pinched, options).empty());
  pinched.pinch->strength *= 2;
  EXPECT_FALSE(check(problem, pinched, options).empty());
  pinched.pinch.reset();
  EXPECT_FALSE(check(problem, pinched, options).empty());
}

TEST(PlanWithAGripper, APinchHoldsTheWholeLoadOrIsNone) {
  const Problem problem = ring_in_gripper(0.02, 0, 0.1);
  const Plan found = plan(problem, {}, cycles(20));
  EXPECT_EQ(found.status, Status::not_secure);
  EXPECT_NE(found.reason.find("N a finger, friction resists 0."), std::string::npos)
      << found.reason;
}

TEST(PlanWithAGripper, RefusesABarThatIsThickerThanItOpens) {
  const Problem problem = ring_in_gripper(0.08, 0, 0.2);
  const Plan found = plan(problem, {}, cycles(1));
  EXPECT_EQ(found.status, Status::too_thick);
  EXPECT_NE(found.reason.find(" mm thick, the hand opens 60 mm"), std::string::npos)
      << found.reason;
}

TEST(DescribeReach, CountsPosesAndDistances) {
  // The arm cannot turn: of six angles about each tangent and two senses, at most one is reached.
  const Problem near = ring_in_gripper(0.02, 0, 0.1);
  EXPECT_NE(describe_reach(near).find("of 96 palm poses"), std::string::npos)
      << describe_reach(near);
  const Problem far = ring_in_gripper(0.02, 9);
  EXPECT_NE(describe_reach(far).find("reaches 0 of 96"), std::string::npos) << describe_reach(far);
  EXPECT_NE(describe_reach(far).find("m beyond the 1."), std::string::npos) << describe_reach(far);
}

}  // namespace
}  // namespace graspless::clasp
