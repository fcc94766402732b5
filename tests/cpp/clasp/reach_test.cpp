// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/reach.hpp"

#include <gtest/gtest.h>

#include "clasp/kinematics.hpp"
#include "hands.hpp"
#include "robot/robots.hpp"

namespace graspless::clasp {
namespace {

class ArmReach : public ::testing::TestWithParam<std::string> {};

TEST_P(ArmReach, NoConfigurationLeavesIt) {
  const RobotWithHand r = robot_with_hand(GetParam());
  const Reach reach = arm_reach(r.robot, r.hand, r.robot.state("home"));
  HandKinematics hand(r.robot, r.hand);
  std::mt19937_64 rng(1);
  double farthest = -reach.radius;
  for (int i = 0; i < 2000; ++i) {
    Eigen::VectorXd q = robot::random_q(r.robot, rng);
    // The hand between open and closed, as it is in a search.
    const double t = i % 5 / 4.0;
    const Eigen::VectorXd &open = r.robot.state(r.hand.open),
                          &closed = r.robot.state(r.hand.closed);
    for (const int j : r.robot.group(r.hand.hand)) q[j] = open[j] + t * (closed[j] - open[j]);
    hand.update(q);
    for (const auto& p_W : hand.nodes().colwise()) {
      farthest = std::max(farthest, reach.excess(p_W));
    }
  }
  EXPECT_LE(farthest, 0);
  EXPECT_GT(farthest, -0.4) << "the ball is much too large";
}

TEST_P(ArmReach, IsTheSameWhereverTheArmStands) {
  const RobotWithHand r = robot_with_hand(GetParam());
  const int first = r.robot.group(r.hand.arm).front();
  const Reach reach = arm_reach(r.robot, r.hand, r.robot.state("home"));
  const double middle = (r.robot.lower()[first] + r.robot.upper()[first]) / 2;
  for (const double q : {middle - 0.05, middle, middle + 0.05, r.robot.lower()[first]}) {
    Eigen::VectorXd start = r.robot.state("home");
    start[first] = q;
    const Reach found = arm_reach(r.robot, r.hand, start);
    EXPECT_NEAR(found.radius, reach.radius, 1e-9);
    EXPECT_TRUE(found.base_W.isApprox(reach.base_W, 1e-9));
  }
}

INSTANTIATE_TEST_SUITE_P(Hands, ArmReach, ::testing::ValuesIn(robots_with_hands()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace graspless::clasp
