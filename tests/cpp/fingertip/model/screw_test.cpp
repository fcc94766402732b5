// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/model/screw.hpp"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "fingertip/cases.hpp"

namespace graspless::fingertip {
namespace {

Eigen::Isometry3d random_pose(std::mt19937_64& rng) {
  std::normal_distribution<double> number;
  return Eigen::Translation3d(number(rng), number(rng), number(rng)) *
         Eigen::Quaterniond(number(rng), number(rng), number(rng), number(rng)).normalized();
}

TEST(FingertipPaths, ScrewArrivesAndComposes) {
  std::mt19937_64 rng(5);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Isometry3d X0 = random_pose(rng);
    // Small and large turns alike; half turns are refused by validate.
    const double scale = std::pow(10.0, -(i % 8));
    mechanics::Vector6d twist = mechanics::Vector6d::Random() * scale;
    const Eigen::Isometry3d X1 = along_screw(X0, twist, 1);
    EXPECT_TRUE(screw_between(X0, X1).isApprox(twist, 1e-7));
    EXPECT_TRUE(along_screw(X0, screw_between(X0, X1), 1).isApprox(X1, 1e-12));
    const Eigen::Isometry3d half = along_screw(X0, twist, 0.5);
    EXPECT_TRUE(along_screw(half, twist, 0.5).isApprox(X1, 1e-12));
    EXPECT_TRUE((X1.linear() * X1.linear().transpose()).isIdentity(1e-12));
  }
}

TEST(FingertipPaths, TwistIsTheDerivative) {
  std::mt19937_64 rng(6);
  const Eigen::Isometry3d X0 = random_pose(rng);
  const mechanics::Vector6d twist = mechanics::Vector6d::Random();
  const Eigen::Vector3d p_O(0.3, -0.2, 0.7);
  const double h = 1e-6;
  const Eigen::Isometry3d X = along_screw(X0, twist, 0.4);
  const Eigen::Vector3d moved =
      (along_screw(X0, twist, 0.4 + h) * p_O - along_screw(X0, twist, 0.4 - h) * p_O) / (2 * h);
  const mechanics::BodyState state = moving_state(X, twist);
  const Eigen::Vector3d v = state.twist_W.head<3>(), omega = state.twist_W.tail<3>();
  EXPECT_TRUE(moved.isApprox(v + omega.cross(X * p_O - X.translation()), 1e-8));
  EXPECT_TRUE(resting_state(X, twist).at_rest);
}

TEST(FingertipPaths, SlidesAndTurnsAreExact) {
  const Eigen::Isometry3d X0 = at(0, 0, 5);
  const Path slide = slide_path(X0, {3, 4, 0}, 10);
  ASSERT_EQ(slide.X_WO.size(), 11U);
  EXPECT_EQ(slide.X_WO.back().translation(), Eigen::Vector3d(3, 4, 5));
  EXPECT_TRUE(screw_between(slide.X_WO[3], slide.X_WO[4]).tail<3>().isZero(0));
  const Path turn = turn_path(X0, {2.5, 0, 0}, {0, 2, 0}, M_PI / 2, 30);
  ASSERT_EQ(turn.X_WO.size(), 31U);
  EXPECT_TRUE(
      (turn.X_WO.back() * Eigen::Vector3d(2.5, 0, 5)).isApprox(Eigen::Vector3d(12.5, 0, 0)));
  for (const Eigen::Isometry3d& X : turn.X_WO) {  // the edge stays
    EXPECT_TRUE((X * Eigen::Vector3d(2.5, 1, -5)).isApprox(Eigen::Vector3d(2.5, 1, 0), 1e-12));
  }
}

TEST(FingertipPaths, JoinWhereTheyMeet) {
  const Path first = slide_path(at(0, 0, 5), {1, 0, 0}, 2);
  const Path second = turn_path(at(1, 0, 5), {3.5, 0, 0}, {0, 1, 0}, 1, 3);
  EXPECT_EQ(join({first, second}).X_WO.size(), 6U);
  expect_refused([&] { join({second, first}); }, "paths[1] must start where the one before ends");
  expect_refused([&] { join({first, Path{}}); }, "paths[1] must not be empty");
}

TEST(FingertipPaths, RefuseNonsense) {
  expect_refused([] { slide_path(at(0, 0, 0), {1, 0, 0}, 0); }, "segments");
  Eigen::Isometry3d scaled = at(0, 0, 0);
  scaled.linear() *= 2;
  expect_refused([&] { slide_path(scaled, {1, 0, 0}, 3); }, "X_WO_start must be a rigid pose");
  expect_refused([&] { turn_path(scaled, {0, 0, 0}, {0, 0, 1}, 1, 3); }, "X_WO_start must be");
  const std::string bound = "segments must be 1 to 99999, not 100000000";
  expect_refused([] { slide_path(at(0, 0, 0), {1, 0, 0}, 100'000'000); }, bound);
  expect_refused([] { turn_path(at(0, 0, 0), {0, 0, 0}, {0, 0, 1}, 1, 100'000'000); }, bound);
  expect_refused([] { slide_path(at(0, 0, 0), {0, 0, 0}, 3); }, "translation_W");
  expect_refused([] { turn_path(at(0, 0, 0), {0, 0, 0}, {0, 0, 0}, 1, 3); }, "axis_W");
  expect_refused([] { turn_path(at(0, 0, 0), {0, 0, 0}, {0, 0, 1}, 0, 3); }, "angle");
}

}  // namespace
}  // namespace graspless::fingertip
