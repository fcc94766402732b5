// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/hand/palm.hpp"

#include <gtest/gtest.h>

#include "clasp/hands.hpp"
#include "clasp/parallel_gripper.hpp"
#include "complaint.hpp"

namespace graspless::clasp {
namespace {

TEST(WithPalmCorners, ParallelGripperGetsOneForEachFinger) {
  const robot::Robot robot = parallel_gripper();
  const Hand given = hand_without_palm();
  expect_refused([&] { validate(given, robot); },
                 "begin hand.fingers.left with {link: palm, point: (0, 0.015, 0.05)}, and "
                 "hand.thumb with {link: palm, point: (0, -0.015, 0.05)}");
  const Hand made = with_palm_corners(given, robot);
  validate(made, robot);
  ASSERT_EQ(made.fingers[0].nodes.size(), 3u);
  EXPECT_EQ(made.thumb.nodes[0].link, "palm");
  EXPECT_TRUE(made.thumb.nodes[0].p_L.isApprox(Eigen::Vector3d(0, -0.015, 0.05)));
}

TEST(WithPalmCorners, IsIdempotentAndLeavesOtherHandsAlone) {
  const auto corners = [](const Hand& hand) {
    std::vector<Eigen::Vector3d> found;
    for (const Finger& finger : hand.fingers)
      for (const CurveNode& node : finger.nodes) found.push_back(node.p_L);
    for (const CurveNode& node : hand.thumb.nodes) found.push_back(node.p_L);
    return found;
  };
  const robot::Robot robot = parallel_gripper();
  const Hand once = with_palm_corners(hand_without_palm(), robot);
  EXPECT_EQ(corners(with_palm_corners(once, robot)), corners(once));
  for (const std::string& name : robots_with_hands()) {
    const RobotWithHand ours = robot_with_hand(name);
    EXPECT_EQ(corners(with_palm_corners(ours.hand, ours.robot)), corners(ours.hand)) << name;
  }
}

TEST(WithPalmCorners, RefusesUnknownNamesLikeValidate) {
  const robot::Robot robot = parallel_gripper();
  Hand hand = hand_without_palm();
  hand.fingers[0].nodes[1].link = "thumb";
  expect_refused([&] { with_palm_corners(hand, robot); }, "hand.fingers.left.nodes[1].link");
}

}  // namespace
}  // namespace graspless::clasp
