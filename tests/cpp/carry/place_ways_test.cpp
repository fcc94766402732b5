// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Objects that hang loose in the hand, and hands that leave as they came.
#include <gtest/gtest.h>

#include "carry/place_search.hpp"
#include "carry/problems.hpp"
#include "complaint.hpp"

namespace graspless::carry {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;

/// The bar hangs lower and further along its axis in the hand.
Problem with_loose_bar(Problem problem) {
  problem.X_WO_hanging = moved(problem.object.X_WB, {0.03, 0, -0.04});
  return problem;
}

TEST(CarryPlace, ALooseObjectHangsOnTheWay) {
  const Problem problem = with_loose_bar(over_table(wam(), {on_table(0.5, -0.2)}));
  Plan found = plan(problem);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(faults_of(problem, found), "");
  EXPECT_TRUE(certify(problem, found));
  const Isometry3d end = segment(found, "retreat").object_poses.back();
  EXPECT_LT((end.matrix() - on_table(0.5, -0.2).matrix()).norm(), 1e-6);
}

TEST(CarryPlace, NothingTouchesALooseObjectAsItHangs) {
  Problem problem = over_table(wam(), {on_table(0.5, -0.2)});
  const Vector3d beside(0.5 + 0.05 + 0.015, -0.2, kTop + 0.04);  // clear of the bar that is held
  problem.obstacles.push_back(
      box("post", {0.01, 0.01, 0.08}, moved(Isometry3d::Identity(), beside)));
  const Plan fast = plan(problem);
  ASSERT_TRUE(fast) << fast.reason;
  EXPECT_EQ(faults_of(problem, fast), "");
  const Problem loose = with_loose_bar(problem);
  EXPECT_EQ(plan(loose).status, Status::no_place);
  const std::string faults = faults_of(loose, fast);
  EXPECT_NE(faults.find("collision"), std::string::npos) << faults;
  EXPECT_NE(faults.find("box hanging"), std::string::npos) << faults;
  EXPECT_FALSE(certify(loose, fast));
}

TEST(CarryPlace, WhatHangsTooLowCannotBeLowered) {
  Problem problem = over_table(wam(), {on_table(0.5, -0.2)});
  const Plan fast = plan(problem);
  ASSERT_TRUE(fast);
  problem.X_WO_hanging = moved(problem.object.X_WB, {0, 0, -0.07});  // more than options.height
  EXPECT_EQ(plan(problem).status, Status::no_place);
  const std::string faults = faults_of(problem, fast);
  EXPECT_NE(faults.find("box hanging"), std::string::npos) << faults;
  Options higher;
  higher.height = 0.1;
  const Plan found = plan(problem, higher);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(faults_of(problem, found, higher), "");
}

/// Its hand leaves along the rows of a retreat, while a finger closes a little.
Problem with_way_out(Problem problem) {
  Plan straight = plan(problem);
  EXPECT_TRUE(straight);
  problem.places->way_out = segment(straight, "retreat").positions;
  VectorXd& last = problem.places->way_out.back();
  last[wam().joint("left_finger_joint")] += 0.02;
  return problem;
}

TEST(CarryPlace, TheHandLeavesAsItCame) {
  Problem problem = with_way_out(over_table(wam(), {on_table(0.5, -0.2)}));
  problem.places->X_WO = {on_table(0.55, 0.15, 1.0)};  // the same way from elsewhere
  Plan found = plan(problem);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(faults_of(problem, found), "");
  const auto& ways = problem.places->way_out;
  const auto& rows = segment(found, "retreat").positions;
  const int frame = wam().frame("grasp");
  const auto way = [&](const VectorXd& a, const VectorXd& b) {
    return Isometry3d(wam().pose(frame, a).inverse() * wam().pose(frame, b)).matrix();
  };
  EXPECT_LT((way(rows.front(), rows.back()) - way(ways.front(), ways.back())).norm(), 1e-3);
}

TEST(CarryPlaceCheck, WantsTheWholeWayOut) {
  const Problem problem = with_way_out(over_table(wam(), {on_table(0.5, -0.2)}));
  const Plan good = plan(problem);
  ASSERT_TRUE(good) << good.reason;
  Plan shorter = good;
  segment(shorter, "retreat").positions.resize(2);
  segment(shorter, "retreat").object_poses.resize(2);
  const std::string faults = faults_of(problem, shorter);
  EXPECT_NE(faults.find("the hand is not at the end of its way out"), std::string::npos) << faults;
  EXPECT_NE(faults.find("the fingers are not as at the end"), std::string::npos) << faults;
}

TEST(CarryPlace, ALooseObjectComesDownAsItSinks) {
  Problem problem = with_loose_bar(over_table(wam(), {on_table(0.5, -0.2), on_table(0.5, -0.1)}));
  const Vector3d sinks_W(0.03, 0, -0.04);  // at the place
  problem.places->down_O = problem.places->X_WO[0].linear().transpose() * sinks_W;
  Plan found = plan(problem);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(faults_of(problem, found), "");
  EXPECT_TRUE(certify(problem, found));
  const auto& poses = segment(found, "lower").object_poses;
  const Vector3d way = poses.back().translation() - poses.front().translation();
  EXPECT_LT((way - sinks_W * (Options{}.height / 0.04)).norm(), 1e-3);
  Problem straight = problem;
  straight.places->down_O.setZero();
  const std::string faults = faults_of(straight, found);
  EXPECT_NE(faults.find("off its straight path"), std::string::npos) << faults;
  problem.places->down_O *= -1;
  expect_refused([&] { plan(problem); }, "places.down_O: must lead down onto 'table'");
}

}  // namespace
}  // namespace graspless::carry
