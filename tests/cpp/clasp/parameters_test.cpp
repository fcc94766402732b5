// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/parameters.hpp"

#include <gtest/gtest.h>

#include "clasp/hand/kinematics.hpp"
#include "clasp/hands.hpp"
#include "clasp/ring_problem.hpp"

namespace graspless::clasp {
namespace {

class OfAHand : public ::testing::TestWithParam<std::string> {
 protected:
  const RobotWithHand r = robot_with_hand(GetParam());
};

TEST_P(OfAHand, ClosesFartherAroundThinnerBars) {
  double last = 1;
  for (const double thickness : {0.001, 0.01, 0.03, 0.05, 0.08}) {
    const double linking = reachable_linking(r.robot, r.hand, thickness);
    EXPECT_LE(linking, last + 0.005) << thickness;  // joints that close in turn may end as well
    EXPECT_GE(linking, open_linking(r.robot, r.hand)) << thickness;
    last = linking;
  }
  EXPECT_GT(reachable_linking(r.robot, r.hand, 0.001), open_linking(r.robot, r.hand) + 0.05);
  EXPECT_EQ(reachable_linking(r.robot, r.hand, 1), open_linking(r.robot, r.hand));
}

TEST_P(OfAHand, IsTooSmallOnlyForThickBars) {
  EXPECT_FALSE(is_too_thick(r.robot, r.hand, 0.03));
  EXPECT_TRUE(is_too_thick(r.robot, r.hand, 0.3));
}

TEST_P(OfAHand, WidthAndThicknessAreThoseOfAHand) {
  EXPECT_GE(half_width(r.robot, r.hand), finger_radius(r.robot, r.hand));
  EXPECT_LT(half_width(r.robot, r.hand), 0.1);
  EXPECT_GT(finger_radius(r.robot, r.hand), 0.004);
  EXPECT_LT(finger_radius(r.robot, r.hand), 0.025);
}

INSTANTIATE_TEST_SUITE_P(Parameters, OfAHand, ::testing::ValuesIn(robots_with_hands()),
                         [](const auto& info) { return info.param; });

TEST(Parameters, KnuckleToKnuckleAndAFingerIsTheWidthOfTheSdh) {
  const RobotWithHand r = robot_with_hand("kr5_sdh");
  EXPECT_NEAR(half_width(r.robot, r.hand), 0.033 + finger_radius(r.robot, r.hand), 1e-9);
}

TEST(Parameters, OnlyZerosAreDerived) {
  const Problem problem = ring_problem();
  Options given;
  given.min_linking = 0.7;
  given.targets = 5;
  const Options same = derived(given, problem, 0);
  EXPECT_EQ(same.min_linking, 0.7);
  EXPECT_EQ(same.targets, 5);

  const Options all = derived({}, problem, 0);
  EXPECT_GT(all.min_linking, open_linking(problem.robot, problem.hand));
  EXPECT_LT(all.min_linking, 1);
  const double length = problem.object.loops().found[0].length;
  EXPECT_NEAR(all.targets, length / half_width(problem.robot, problem.hand), 1);
}

}  // namespace
}  // namespace graspless::clasp
