// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/close.hpp"

#include <gtest/gtest.h>

#include "clasp/spaces.hpp"

namespace graspless::clasp {
namespace {

using Eigen::VectorXd;

class CloseHandOf : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Hands, CloseHandOf, testing::ValuesIn(robots_with_hands()));

TEST_P(CloseHandOf, EndsWhereNoJointCanGoOn) {
  const Problem problem = ring_within(GetParam(), 0.03, 0.02);
  FreeSpace space(problem);
  ASSERT_TRUE(space.is_free(problem.q_start));
  const auto rows = close_hand(space, problem.robot, problem.hand, problem.q_start);
  const VectorXd& end = rows.back();
  const VectorXd& closed = problem.robot.state(problem.hand.closed);
  EXPECT_EQ(rows.front(), problem.q_start);
  int stopped = 0;
  for (const int joint : problem.robot.group(problem.hand.hand)) {
    const double left = closed[joint] - end[joint];
    if (left == 0) continue;
    VectorXd next = end;
    next[joint] += std::clamp(left, -0.01, 0.01);
    EXPECT_FALSE(space.is_free(next)) << problem.robot.joint_names()[joint];
    ++stopped;
  }
  EXPECT_GT(stopped, 0);  // the ring is in the way
}

TEST_P(CloseHandOf, RowsAreNearAndEveryMotionBetweenThemIsFree) {
  const Problem problem = ring_within(GetParam(), 0.03, 0.02);
  FreeSpace space(problem);
  ASSERT_TRUE(space.is_free(problem.q_start));
  const auto rows = close_hand(space, problem.robot, problem.hand, problem.q_start);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_LE((rows[i] - rows[i - 1]).cwiseAbs().maxCoeff(), 0.05 + 1e-12);
    EXPECT_TRUE(space.is_free(rows[i - 1], rows[i], 0.01)) << "row " << i;
    for (const int joint : problem.robot.group(problem.hand.arm)) {
      EXPECT_EQ(rows[i][joint], problem.q_start[joint]);
    }
  }
}

TEST(CloseHand, OpenAirAndFullLimitsEndAtTheClosedState) {
  Problem problem = ring_within("kr5_sdh");
  problem.X_WO.translation().z() += 2;
  FreeSpace space(problem);
  const auto rows = close_hand(space, problem.robot, problem.hand, problem.q_start);
  const VectorXd& closed = problem.robot.state(problem.hand.closed);
  // Two parallel fingers and a thumb between them: nothing stops them.
  for (const int joint : problem.robot.group(problem.hand.hand)) {
    EXPECT_NEAR(rows.back()[joint], closed[joint], 1e-12);
  }
  EXPECT_EQ(close_hand(space, problem.robot, problem.hand, rows.back()).size(), 1u);
}

}  // namespace
}  // namespace graspless::clasp
