// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "graspless/robot/robot.hpp"

#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// Points on the outside of a shape, in the frame of its link.
Eigen::Matrix3Xd points_of(const geometry::PlacedShape& placed) {
  Eigen::Matrix3Xd p_G(3, 0);
  const auto add = [&](const Vector3d& p) {
    p_G.conservativeResize(3, p_G.cols() + 1);
    p_G.rightCols<1>() = p;
  };
  const auto add_ball = [&](const Vector3d& center, double radius) {
    for (double a = -3; a < 3; a += 0.5) {
      for (double b = -1.5; b <= 1.5; b += 0.5) {
        add(center +
            radius * Vector3d(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)));
      }
    }
  };
  if (const auto* box = std::get_if<geometry::Box>(&placed.shape)) {
    for (int i = 0; i < 8; ++i) {
      add(box->size.cwiseProduct(
          Vector3d(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5)));
    }
  } else if (const auto* sphere = std::get_if<geometry::Sphere>(&placed.shape)) {
    add_ball(Vector3d::Zero(), sphere->radius);
  } else if (const auto* capsule = std::get_if<geometry::Capsule>(&placed.shape)) {
    add_ball(Vector3d(0, 0, capsule->length / 2), capsule->radius);
    add_ball(Vector3d(0, 0, -capsule->length / 2), capsule->radius);
  } else if (const auto* convex = std::get_if<geometry::Convex>(&placed.shape)) {
    p_G = convex->vertices;
  } else if (const auto* mesh = std::get_if<geometry::Mesh>(&placed.shape)) {
    p_G = mesh->vertices;
  }
  return placed.X_BG * p_G;
}

TEST(TreeTables, ReachBoundsEveryMotion) {
  std::mt19937_64 rng(6);
  for (const Robot& robot : {wam(), kr5(), oddity()}) {
    double tightest = std::numeric_limits<double>::infinity();
    for (int sample = 0; sample < 400; ++sample) {
      const VectorXd q1 = random_q(robot, rng);
      // Far pairs and near ones: only near ones come close to the bound.
      const double share = sample % 2 == 0 ? 1 : 0.01;
      const VectorXd q2 = q1 + share * (random_q(robot, rng) - q1);
      for (const LinkShape& shape : robot.shapes()) {
        const Eigen::Matrix3Xd p_L = points_of(shape.placed);
        const Eigen::Matrix3Xd moved =
            robot.pose(shape.link, q2) * p_L - robot.pose(shape.link, q1) * p_L;
        const double bound = robot.reach(shape.link).dot((q2 - q1).cwiseAbs());
        const double distance = moved.colwise().norm().maxCoeff();
        EXPECT_LE(distance, bound + 1e-12) << robot.frame_names()[shape.link];
        if (distance > 0) tightest = std::min(tightest, bound / distance);
      }
    }
    EXPECT_LT(tightest, 1.5);  // a bound, but not a wasteful one
  }
}

TEST(TreeTables, NeighboursAreNeverTested) {
  const Robot robot = oddity();
  const auto ignored = [&](const std::string& a, const std::string& b) {
    const int i = robot.frame(a), j = robot.frame(b);
    return robot.ignored_pairs().count({std::min(i, j), std::max(i, j)}) == 1;
  };
  EXPECT_TRUE(ignored("root", "slide"));  // z_link between them has no shape
  EXPECT_TRUE(ignored("slide", "welded"));
  EXPECT_TRUE(ignored("welded", "turner"));
  EXPECT_TRUE(ignored("turner", "echo_link"));
  EXPECT_TRUE(ignored("turner", "tip"));
  EXPECT_FALSE(ignored("root", "welded"));
  EXPECT_FALSE(ignored("slide", "turner"));
  EXPECT_FALSE(ignored("echo_link", "tip"));  // siblings
  const Robot arm = wam();
  EXPECT_EQ(arm.ignored_pairs().count({arm.frame("base_link"), arm.frame("wam_link_3")}), 1u);
  EXPECT_EQ(arm.ignored_pairs().count({arm.frame("left_finger"), arm.frame("right_finger")}), 0u);
}

}  // namespace
}  // namespace graspless::robot
