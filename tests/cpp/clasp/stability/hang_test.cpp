// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "graspless/clasp/clasp.hpp"

#include "clasp/hand/kinematics.hpp"
#include "clasp/ring_problem.hpp"
#include "complaint.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kRadius = 0.12;  // of the ring [m]

/// A ring that a hand has clasped, and the configuration of the closed hand.
struct Clasped {
  Problem problem;
  VectorXd q;
  int loop;

  Vector3d center_W() const {
    HandKinematics hand(problem.robot, problem.hand);
    hand.update(q);
    return (hand.nodes().rowwise().minCoeff() + hand.nodes().rowwise().maxCoeff()) / 2;
  }
};

const Clasped& clasped() {
  static const Clasped found = [] {
    const Problem problem = ring_problem();
    planning::Budget budget;
    budget.seed = 1;
    const Plan plan = clasp::plan(problem, {}, budget);
    EXPECT_TRUE(plan) << plan.reason;
    return Clasped{problem, plan.segments.back().positions.back(), plan.loop};
  }();
  return found;
}

TEST(Hang, TheMiddleOfARingHangsBelowTheHand) {
  const Clasped& given = clasped();
  const Hang found = find_hang(given.problem, given.q, given.loop);
  ASSERT_TRUE(found.holds);
  EXPECT_GE(found.drop, 0);
  const Vector3d off = found.X_WO.translation() - given.center_W();
  EXPECT_LT(off.head<2>().norm(), 0.06);  // plumb, but for the size of the hand
  EXPECT_LT(off.z(), -kRadius + 0.04);
  EXPECT_NEAR(found.drop, given.problem.X_WO.translation().z() - found.X_WO.translation().z(),
              1e-3);  // the mean of its points is its middle
}

TEST(Hang, WhatHangsDoesNotSinkAnyMore) {
  Clasped given = clasped();
  given.problem.X_WO = find_hang(given.problem, given.q, given.loop).X_WO;
  const Hang again = find_hang(given.problem, given.q, given.loop);
  EXPECT_TRUE(again.holds);
  EXPECT_LT(again.drop, 2e-3);
}

TEST(Hang, DoesNotEnterTheHand) {
  const Clasped& given = clasped();
  const Hang found = find_hang(given.problem, given.q, given.loop);
  Problem hung = given.problem;
  hung.X_WO = found.X_WO;
  StabilityOptions options;
  options.penetration = 0.004;  // a surface of points 1.5 mm apart, and steps that are linear
  options.force = options.torque = 0;
  EXPECT_TRUE(test_stability(hung, given.q, given.loop, options).secure);
}

TEST(Hang, AnOpenHandLosesIt) {
  const Clasped& given = clasped();
  VectorXd q = given.q;
  const VectorXd open = given.problem.robot.state(given.problem.hand.open);
  for (const int joint : given.problem.robot.group(given.problem.hand.hand)) q[joint] = open[joint];
  Problem apart = given.problem;
  apart.X_WO.translation().z() -= 0.3;  // a ring below the hand
  EXPECT_FALSE(find_hang(apart, q, given.loop).holds);
}

TEST(Hang, NamesWhatIsWrong) {
  const Clasped& given = clasped();
  const VectorXd few = VectorXd::Zero(2);
  EXPECT_NE(complaint([&] { find_hang(given.problem, few, given.loop); }).find("q"),
            std::string::npos);
  EXPECT_NE(complaint([&] { find_hang(given.problem, given.q, 7); }).find("loop"),
            std::string::npos);
}

}  // namespace
}  // namespace graspless::clasp
