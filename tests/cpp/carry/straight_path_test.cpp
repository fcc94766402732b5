// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "carry/straight_path.hpp"

#include <gtest/gtest.h>

#include "carry/problems.hpp"

namespace graspless::carry {
namespace {

using Eigen::AngleAxisd, Eigen::Isometry3d, Eigen::Vector3d;

const Isometry3d kStart =
    Eigen::Translation3d(0.4, -0.2, 0.3) * AngleAxisd(0.7, Vector3d(1, 2, -1).normalized());
const Isometry3d kGoal =
    moved(kStart, {0.1, 0.2, -0.05}) * AngleAxisd(0.9, Vector3d(0.2, -1, 0.4).normalized());
const Isometry3d kTurned = kStart * AngleAxisd(0.9, Vector3d(0.2, -1, 0.4).normalized());

TEST(StraightPath, LeadsFromStartToGoal) {
  for (const Isometry3d& goal : {kGoal, kTurned}) {
    const StraightPath path(kStart, goal);
    EXPECT_TRUE(path.pose(0, 0).isApprox(kStart, 1e-12));
    EXPECT_TRUE(path.pose(1, 0).isApprox(goal, 1e-12));
    EXPECT_NEAR(path.angle(), 0.9, 1e-12);
  }
  EXPECT_NEAR(StraightPath(kStart, kGoal).distance(), Vector3d(0.1, 0.2, -0.05).norm(), 1e-12);
  EXPECT_NEAR(StraightPath(kStart, kTurned).distance(), 0, 1e-12);
}

TEST(StraightPath, ContainsItsOwnPoses) {
  Options options;
  options.max_twist = 0.4;
  for (const Isometry3d& goal : {kGoal, moved(kStart, {0, 0, 0.1})}) {
    const StraightPath path(kStart, goal);
    for (const double s : {0.0, 0.3, 0.77, 1.0}) {
      for (const double twist : {-0.4, -0.1, 0.0, 0.4}) {
        EXPECT_TRUE(path.contains(path.pose(s, twist), options)) << s << " " << twist;
      }
    }
  }
}

TEST(StraightPath, ContainsNothingBesideIt) {
  Options options;
  options.max_twist = 0.1;
  const StraightPath path(kStart, kGoal);
  const Isometry3d on = path.pose(0.4, 0);
  const Vector3d aside = Vector3d(0.1, 0.2, -0.05).unitOrthogonal();
  EXPECT_TRUE(path.contains(moved(on, 0.5 * options.tolerance * aside), options));
  EXPECT_FALSE(path.contains(moved(on, 1.5 * options.tolerance * aside), options));
  Isometry3d turned = on;
  turned.linear() = AngleAxisd(0.02, aside) * on.linear();
  EXPECT_FALSE(path.contains(turned, options));
  EXPECT_TRUE(path.contains(path.pose(0.4, 0.1), options));
  EXPECT_FALSE(path.contains(path.pose(0.4, 0.11), options));
  const Vector3d along = Vector3d(0.1, 0.2, -0.05).normalized();
  EXPECT_FALSE(path.contains(moved(kGoal, 0.01 * along), options));
  EXPECT_FALSE(path.contains(moved(kStart, -0.01 * along), options));
}

}  // namespace
}  // namespace graspless::carry
