// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/load.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "graspless/clasp/clasp.hpp"

#include "clasp/parallel_gripper.hpp"
#include "clasp/ring_problem.hpp"
#include "complaint.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// A bar of 20 mm along x between the fingers: the lowest part of a ring above the palm.
Problem bar_between_fingers() {
  const robot::Robot robot = parallel_gripper();
  Problem problem{robot,
                  with_palm_corners(hand_without_palm(), robot),
                  Object::from_cloud("ring", ring_cloud(0.12, 0.02, 160, 16)),
                  Eigen::Isometry3d::Identity(),
                  {},
                  robot.state("open"),
                  {},
                  {},
                  {}};
  problem.X_WO.linear() = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ()).toRotationMatrix();
  problem.X_WO.translation() = Vector3d(0, 0, 1.21);
  return problem;
}

/// Effort of the hand closed to a gap on each side of the bar [m].
double effort(const Problem& problem, double torque, double gap = 0.0015) {
  VectorXd q = problem.q_start;
  q[problem.robot.joint("slide_left")] = 0.01 + gap;
  return LoadTester(problem).effort(q, {0, 0, 1.09}, 0.06, 0, torque);
}

TEST(LoadTester, ABarThatTurnsPushesTheFingersApartAtTheirEdges) {
  const Problem problem = bar_between_fingers();
  // The edges are 20 mm apart. Each finger opens by the same length, against 50 N.
  const double expected = kSudden * 2 * 0.2 / 0.02 / 50;
  EXPECT_NEAR(effort(problem, 0.2), expected, 0.15 * expected);
  EXPECT_NEAR(effort(problem, 0.1), expected / 2, 0.075 * expected);
  EXPECT_GT(effort(problem, 1), 1);
  EXPECT_EQ(effort(problem, 0), 0);
}

TEST(LoadTester, FingersThatTouchNothingAreNotLoaded) {
  EXPECT_LT(effort(bar_between_fingers(), 1, 0.0195), 0.01);
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
  Problem problem = bar_between_fingers();
  problem.robot = parallel_gripper("0");
  EXPECT_EQ(problem.robot.max_effort()[problem.robot.joint("slide_left")],
            std::numeric_limits<double>::infinity());
  expect_refused([&] { plan(problem); }, "joint 'slide_left' of the hand has no effort limit");
  expect_refused([&] { test_stability(problem, problem.q_start, 0); }, "slide_left");
  expect_refused([&] { test_pinch(problem, problem.q_start, 0.5); }, "slide_left");
  StabilityOptions none;
  none.force = none.torque = 0;
  EXPECT_EQ(test_stability(problem, problem.q_start, 0, none).effort, 0);
}

}  // namespace
}  // namespace graspless::clasp
