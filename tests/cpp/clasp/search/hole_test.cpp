// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/hole.hpp"

#include <gtest/gtest.h>

#include "graspless/clasp/clasp.hpp"

#include "clasp/parameters.hpp"
#include "clasp/ring_problem.hpp"

namespace graspless::clasp {
namespace {

TEST(HoleWidth, IsThatOfTheLargestBall) {
  for (const double radius : {0.02, 0.05, 0.12}) {
    const double thickness = radius / 4;
    Eigen::Matrix3Xd cloud = ring_cloud(radius, thickness);
    const Object round = Object::from_cloud("ring", cloud);
    const double width = hole_width(round, 0, 1);
    EXPECT_NEAR(width, 2 * radius - thickness, 0.01 * width + 0.0005);  // flat between points
    cloud.row(1) *= 2;
    EXPECT_NEAR(hole_width(Object::from_cloud("oval", cloud), 0, 1), width, 0.1 * width);
    EXPECT_GE(hole_width(round, 0, 0.01), 0.01);
    EXPECT_LE(hole_width(round, 0, 0.01), width);
  }
}

TEST(HoleWidth, CountsWhatStandsInTheHole) {
  const Eigen::Matrix3Xd ring = ring_cloud(0.1, 0.02);
  Eigen::Matrix3Xd cloud(3, ring.cols() + 1);
  cloud << ring, Eigen::Vector3d::Zero();
  geometry::LoopOptions options;
  options.max_edge_length = 0.05;
  const double width = hole_width(Object::from_cloud("ring", cloud, options), 0, 1);
  EXPECT_NEAR(width, 0.09, 0.003);  // between the point in the middle and the ring
}

TEST(NeededWidth, IsThatOfTheThumbOrOfAllFingers) {
  RobotWithHand r = robot_with_hand("kr5_sdh");
  const double thumb = 2 * tip_radius(r.robot, r.hand.thumb);
  EXPECT_GT(thumb, 0.02);
  EXPECT_LT(thumb, 0.04);
  EXPECT_EQ(needed_width(r.robot, r.hand), thumb);
  r.hand.thumb.nodes.back().link = r.hand.frame;  // a thick one: the fingers must pass
  EXPECT_EQ(needed_width(r.robot, r.hand), 2 * tip_radius(r.robot, r.hand.fingers[0]));
}

TEST(HoleTooNarrow, NamesBothWidthsWhereNoFingerPasses) {
  Problem problem = ring_problem();
  problem.object = Object::from_cloud("small ring", ring_cloud(0.015, 0.008));
  const planning::Budget budget{60, 3, 1, {}};
  const Plan refused = plan(problem, {}, budget);
  EXPECT_EQ(refused.status, Status::hole_too_narrow);
  EXPECT_EQ(refused.statistics.cycles, 0);
  EXPECT_NE(refused.reason.find("its hole is 22 mm wide"), std::string::npos) << refused.reason;
  EXPECT_NE(refused.reason.find("a finger 27 mm"), std::string::npos) << refused.reason;
  Options any;
  any.must_be_secure = false;
  EXPECT_NE(plan(problem, any, budget).status, Status::hole_too_narrow);
  problem.object = Object::from_cloud("wider ring", ring_cloud(0.02, 0.008));  // 32 mm
  const Plan failed = plan(problem, {}, budget);
  ASSERT_EQ(failed.status, Status::not_found) << failed.reason;
  EXPECT_NE(failed.reason.find("its hole is 32 mm wide, its handle "), std::string::npos)
      << failed.reason;
  // Sizes are told, too, if the time ends the search.
  const Plan late = plan(problem, {}, planning::Budget{1, 1000000, 1, {}});
  ASSERT_FALSE(late) << "fewer fingers may clasp it, but not so that it holds";
  EXPECT_NE(late.reason.find("its hole is 32 mm wide"), std::string::npos) << late.reason;
}

}  // namespace
}  // namespace graspless::clasp
