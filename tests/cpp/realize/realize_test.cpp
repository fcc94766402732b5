// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/realize/realize.hpp"

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "realize/plans.hpp"
#include "robot/robots.hpp"

namespace graspless::fingertip {
namespace {

using Eigen::VectorXd;

std::vector<std::string> names(const Realization& result) {
  std::vector<std::string> all;
  for (const JointSegment& segment : result.segments) all.push_back(segment.name);
  return all;
}

double longest_step(const Realization& result) {
  double longest = 0;
  const VectorXd* before = &result.segments.front().positions.front();
  for (const JointSegment& segment : result.segments) {
    for (const VectorXd& q : segment.positions) {
      longest = std::max(longest, (q - *before).lpNorm<Eigen::Infinity>());
      before = &q;
    }
  }
  return longest;
}

/// Both arms of two_arms() straight ahead.
VectorXd aside() {
  VectorXd q = VectorXd::Zero(6);
  q[0] = 1.2;
  q[3] = -1.2;
  return q;
}

TEST(FingertipRealize, TheWamTumblesABlock) {
  const BlockTumble given;
  const Plan plan = solved({displacement("tumble", given.path, given.pinch)});
  const robot::Robot& robot = wam_tips();
  const VectorXd home = robot.state("home");
  const Realization result = realize(given.problem, plan, robot, t42(), home);
  ASSERT_TRUE(result) << result.reason;
  EXPECT_EQ(joined(check(given.problem, plan, robot, t42(), result)), "");
  EXPECT_EQ(names(result),
            (std::vector<std::string>{"approach", "touch", "tumble", "release", "retreat"}));
  EXPECT_EQ(result.segments.front().positions.front(), home);
  EXPECT_EQ(result.segments.back().positions.back(), home);
  EXPECT_LE(longest_step(result), RealizeOptions().max_jump + 1e-12);
}

TEST(FingertipRealize, FingersMayBeAssignedEitherWay) {
  BlockTumble given;
  const robot::Robot& robot = wam_tips();
  std::swap(given.pinch[0], given.pinch[1]);
  const Plan plan = solved({displacement("tumble", given.path, given.pinch)});
  const Realization result = realize(given.problem, plan, robot, t42(), robot.state("home"));
  ASSERT_TRUE(result) << result.reason;
  EXPECT_EQ(joined(check(given.problem, plan, robot, t42(), result)), "");
}

TEST(FingertipRealize, TwoArmsSlideRegraspAndSlideOn) {
  const CubeSlide given;
  const VectorXd home = aside();
  const Realization result = realize(given.problem, given.plan, two_arms(), two_tips(), home);
  ASSERT_TRUE(result) << result.reason;
  EXPECT_EQ(joined(check(given.problem, given.plan, two_arms(), two_tips(), result)), "");
  EXPECT_EQ(names(result),
            (std::vector<std::string>{"approach", "touch", "slide", "release", "reach", "touch",
                                      "slide", "release", "retreat"}));
  EXPECT_LE(longest_step(result), RealizeOptions().max_jump + 1e-12);
}

TEST(FingertipRealize, OneFingerOfTheHandMovesWhileTheOtherHolds) {
  const BlockTumble given;
  const Path first{{given.path.X_WO.begin(), given.path.X_WO.begin() + 4}};
  const Path second{{given.path.X_WO.begin() + 3, given.path.X_WO.end()}};
  Presses lower = given.pinch;
  lower[1].first.z() -= 0.015;
  const Plan plan =
      solved({displacement("tumble", first, given.pinch),
              regrasp(first.X_WO.back(), given.pinch, 1), displacement("tumble", second, lower)});
  const robot::Robot& robot = wam_tips();
  const Realization result = realize(given.problem, plan, robot, t42(), robot.state("home"));
  ASSERT_TRUE(result) << result.reason;
  EXPECT_EQ(joined(check(given.problem, plan, robot, t42(), result)), "");
}

TEST(FingertipRealize, SameSeedSameMotion) {
  const CubeSlide given;
  planning::Budget budget;
  budget.seed = 7;
  const auto once = realize(given.problem, given.plan, two_arms(), two_tips(), aside(), {}, budget);
  const auto again =
      realize(given.problem, given.plan, two_arms(), two_tips(), aside(), {}, budget);
  ASSERT_TRUE(once && again) << once.reason << again.reason;
  ASSERT_EQ(once.segments.size(), again.segments.size());
  for (std::size_t i = 0; i < once.segments.size(); ++i)
    EXPECT_EQ(once.segments[i].positions, again.segments[i].positions);
}

TEST(FingertipRealize, ShorterStepsWhereAskedFor) {
  const CubeSlide given;
  RealizeOptions options;
  options.max_jump = 0.01;
  options.resolution = 0.005;
  const auto result = realize(given.problem, given.plan, two_arms(), two_tips(), aside(), options);
  ASSERT_TRUE(result) << result.reason;
  EXPECT_LE(longest_step(result), 0.01 + 1e-12);
  EXPECT_EQ(joined(check(given.problem, given.plan, two_arms(), two_tips(), result, options)), "");
}

TEST(FingertipRealize, EverySeedGivesAMotionThatHolds) {
  const CubeSlide given;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    planning::Budget budget;
    budget.seed = seed;
    const auto result =
        realize(given.problem, given.plan, two_arms(), two_tips(), aside(), {}, budget);
    ASSERT_TRUE(result) << seed << ": " << result.reason;
    EXPECT_EQ(joined(check(given.problem, given.plan, two_arms(), two_tips(), result)), "");
  }
}

TEST(FingertipRealize, ABlockOutOfReachIsMissedByADistance) {
  const BlockTumble given({1.5, 0, 0});
  const Plan plan = solved({displacement("tumble", given.path, given.pinch)});
  const robot::Robot& robot = wam_tips();
  RealizeOptions options;
  options.restarts = 3;
  const Realization result =
      realize(given.problem, plan, robot, t42(), robot.state("home"), options);
  EXPECT_FALSE(result);
  EXPECT_TRUE(result.segments.empty());
  EXPECT_CONTAINS(result.reason, "segment 0 (tumble), row 0");
  EXPECT_CONTAINS(result.reason, "tip_center' misses the place of finger");
  EXPECT_CONTAINS(result.reason, " mm");
}

TEST(FingertipRealize, ABlockTooWideForTheHandIsRefused) {
  BlockTumble given;
  given.problem.object = Object::box("block", {0.04, 0.3, 0.08}, 0.15);
  const Presses wide{{{0, -0.15, 0.01}, {0, 1, 0}}, {{0, 0.15, 0.01}, {0, -1, 0}}};
  const Plan plan = solved({displacement("tumble", given.path, wide)});
  const robot::Robot& robot = wam_tips();
  RealizeOptions options;
  options.restarts = 3;
  const auto result = realize(given.problem, plan, robot, t42(), robot.state("home"), options);
  EXPECT_FALSE(result);
  EXPECT_CONTAINS(result.reason, "misses the place of finger");
}

TEST(FingertipRealize, WhatStandsInTheWayIsNamed) {
  BlockTumble given;
  const geometry::PlacedShape lid{geometry::Box{{0.3, 0.3, 0.02}}};
  given.problem.obstacles.push_back({"lid", {lid}, at(0.6, 0, 0.11)});
  const Plan plan = solved({displacement("tumble", given.path, given.pinch)});
  const robot::Robot& robot = wam_tips();
  RealizeOptions options;
  options.restarts = 3;
  const auto result = realize(given.problem, plan, robot, t42(), robot.state("home"), options);
  EXPECT_FALSE(result);
  EXPECT_CONTAINS(result.reason, "'lid'");
}

TEST(FingertipRealize, AWallThroughTheArmIsTold) {
  BlockTumble given;
  given.problem.planes.push_back({"wall", {0, -1, 0}, -0.12});
  const Plan plan = solved({displacement("tumble", given.path, given.pinch)});
  const robot::Robot& robot = wam_tips();
  const auto result = realize(given.problem, plan, robot, t42(), robot.state("home"));
  EXPECT_FALSE(result);
  EXPECT_CONTAINS(result.reason, "q_home: ");
  EXPECT_CONTAINS(result.reason, "'wall'");
}

TEST(FingertipRealize, WhatThePlannerFindsForABlock) {
  BlockTumble given;
  const Plan found = plan(given.problem);
  ASSERT_TRUE(found) << found.reason;
  const robot::Robot& robot = wam_tips();
  const auto result = realize(given.problem, found, robot, t42(), robot.state("home"));
  ASSERT_TRUE(result) << result.reason;
  EXPECT_EQ(joined(check(given.problem, found, robot, t42(), result)), "");
  EXPECT_LT(result.segments[2].scrub, 1e-3);  // a pinch: the block turns between the fingers
}

// A cube of 6 cm is wider than the hand's fingers stand when they are parallel: a pinch of its
// sides would have them lean into it. Fingertips that stay closer press from the top and from
// behind.
TEST(FingertipRealize, PlansThatFitTheHandsOpening) {
  BlockTumble given;
  given.start = at(0.6, 0, 0.03);
  given.problem.object = Object::box("block", {0.06, 0.06, 0.06}, 0.2);
  given.problem.motion =
      turn_path(given.start, {0.63, 0, 0}, Eigen::Vector3d::UnitY(), M_PI / 2, 6);
  const robot::Robot& robot = wam_tips();
  RealizeOptions options;
  options.restarts = 4;
  const Plan wide = plan(given.problem);
  ASSERT_TRUE(wide) << wide.reason;
  EXPECT_FALSE(realize(given.problem, wide, robot, t42(), robot.state("home"), options));
  given.problem.fingers.max_span = 0.078;
  const Plan narrow = plan(given.problem);
  ASSERT_TRUE(narrow) << narrow.reason;
  EXPECT_GE(narrow.cost, wide.cost);
  EXPECT_EQ(joined(check(given.problem, narrow)), "");
  const auto result = realize(given.problem, narrow, robot, t42(), robot.state("home"));
  ASSERT_TRUE(result) << result.reason;
  EXPECT_EQ(joined(check(given.problem, narrow, robot, t42(), result)), "");
}

TEST(FingertipRealize, OneFingerPushesAndTheOtherArmStandsStill) {
  CubeSlide given;
  given.problem.fingers.count = 1;
  given.problem.motion = given.first;
  const Presses behind{{{-0.03, 0, 0}, {1, 0, 0}}};
  const Plan plan = solved({displacement("slide", given.first, behind)});
  const Carrier carrier{{"left_tip"}, {{"left_3"}}};
  const auto result = realize(given.problem, plan, two_arms(), carrier, aside());
  ASSERT_TRUE(result) << result.reason;
  EXPECT_EQ(joined(check(given.problem, plan, two_arms(), carrier, result)), "");
  for (const JointSegment& segment : result.segments) {
    for (const VectorXd& q : segment.positions) EXPECT_EQ(q.tail(3), aside().tail(3));
  }
}

TEST(FingertipRealize, TimeThatIsUpIsTold) {
  const CubeSlide given;
  planning::Budget budget;
  budget.iterations = 0;
  const auto result =
      realize(given.problem, given.plan, two_arms(), two_tips(), aside(), {}, budget);
  EXPECT_FALSE(result);
  EXPECT_CONTAINS(result.reason, "out of time");
  budget = {};
  budget.interrupted = [] { return true; };
  EXPECT_CONTAINS(
      realize(given.problem, given.plan, two_arms(), two_tips(), aside(), {}, budget).reason,
      "interrupted");
}

TEST(FingertipRealize, BadInputIsNamed) {
  const CubeSlide given;
  const auto with = [&](const Carrier& carrier, const VectorXd& home,
                        const RealizeOptions& options) {
    return [=, &given] { realize(given.problem, given.plan, two_arms(), carrier, home, options); };
  };
  const Carrier good = two_tips();
  Carrier bad = good;
  bad.fingertips[1] = "thumb";
  expect_refused(with(bad, aside(), {}), "thumb");
  bad = good;
  bad.fingertips[1] = "stand";
  expect_refused(with(bad, aside(), {}), "carrier.fingertips[1] 'stand' is not moved by any joint");
  bad = good;
  bad.fingertips[1] = bad.fingertips[0];
  expect_refused(with(bad, aside(), {}), "given twice");
  bad = good;
  bad.links.pop_back();
  expect_refused(with(bad, aside(), {}), "one entry for each of the 2 fingers");
  expect_refused(with(good, VectorXd::Zero(3), {}), "q_home has 3 values for 6 joints");
  expect_refused(with(good, VectorXd::Constant(6, 3), {}),
                 "q_home: joint 'left_joint_1' is 3, outside its limits");
  RealizeOptions options;
  options.max_jump = 0;
  expect_refused(with(good, aside(), options),
                 "options.max_jump must lie in (0, inf) rad or m, not 0");
  Plan unsolved;
  unsolved.reason = "no friction";
  expect_refused([&] { realize(given.problem, unsolved, two_arms(), good, aside()); },
                 "plan is not solved: no friction");
}

TEST(FingertipRealize, AHomeThatTouchesIsTold) {
  const CubeSlide given;
  const auto result = realize(given.problem, given.plan, two_arms(), two_tips(), VectorXd::Zero(6));
  EXPECT_FALSE(result);
  EXPECT_CONTAINS(result.reason, "q_home: 'left_3' touches 'right_3'");
}

}  // namespace
}  // namespace graspless::fingertip
