// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "graspless/geometry/loops.hpp"

#include "complaint.hpp"

namespace graspless::geometry {
namespace {

/// A circle of radius 1 in n corners; every second one `zigzag` off its plane.
Eigen::Matrix3Xd zigzag_circle(int n, double zigzag = 0) {
  Eigen::Matrix3Xd loop(3, n);
  for (int i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n;
    loop.col(i) << std::cos(a), std::sin(a), i % 2 == 0 ? zigzag : -zigzag;
  }
  return loop;
}

TEST(ClaspTargets, OfASquareAreWhereTheyMustBe) {
  Eigen::Matrix3Xd square(3, 4);
  square << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  const auto targets = clasp_targets(square, 8);
  ASSERT_EQ(targets.size(), 8u);
  EXPECT_TRUE(targets[0].point.isApprox(Eigen::Vector3d(0, 0, 0)));
  EXPECT_TRUE(targets[1].point.isApprox(Eigen::Vector3d(0.5, 0, 0)));
  EXPECT_TRUE(targets[4].point.isApprox(Eigen::Vector3d(1, 1, 0)));
  EXPECT_TRUE(targets[1].tangent.isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_TRUE(targets[7].tangent.isApprox(Eigen::Vector3d(0, -1, 0)));
  EXPECT_TRUE(targets[2].tangent.isApprox(Eigen::Vector3d(1, 1, 0).normalized()));  // a corner
}

TEST(ClaspTargets, AreEquallyFarApart) {
  for (const int count : {1, 2, 3, 12, 40}) {
    const auto targets = clasp_targets(zigzag_circle(500), count);
    for (int i = 0; i < count; ++i) {
      const double a = 2 * M_PI * i / count;
      const auto& target = targets[i];
      EXPECT_LT((target.point - Eigen::Vector3d(std::cos(a), std::sin(a), 0)).norm(), 1e-4);
      EXPECT_LT((target.tangent - Eigen::Vector3d(-std::sin(a), std::cos(a), 0)).norm(), 1e-2);
    }
  }
}

TEST(ClaspTargets, DoNotFollowTheZigzag) {
  for (const auto& target : clasp_targets(zigzag_circle(60, 0.05), 12)) {
    const Eigen::Vector3d p = target.point;
    EXPECT_GT(target.tangent.dot(Eigen::Vector3d(-p.y(), p.x(), 0).normalized()), 0.97);
    EXPECT_NEAR(target.tangent.norm(), 1, 1e-12);
  }
}

TEST(ClaspTargets, AreFiniteOnALoopThatRunsBack) {
  Eigen::Matrix3Xd there_and_back(3, 4);
  there_and_back << 0, 1, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0;
  for (const auto& target : clasp_targets(there_and_back, 4)) {
    EXPECT_TRUE(target.point.allFinite());
    EXPECT_NEAR(target.tangent.norm(), 1, 1e-12);
  }
}

TEST(ClaspTargets, RefuseWhatHasNoLength) {
  Eigen::Matrix3Xd nan = zigzag_circle(5);
  nan(0, 3) = std::numeric_limits<double>::quiet_NaN();
  expect_refused([] { clasp_targets(zigzag_circle(5), 0); },
                 "count must lie in [1, 1000000], not 0");
  expect_refused([] { clasp_targets(zigzag_circle(5), 1000001); }, "not 1000001");
  expect_refused([] { clasp_targets(Eigen::Matrix3Xd(3, 0), 4); }, "not 0 corners");
  expect_refused([] { clasp_targets(Eigen::Matrix3Xd::Ones(3, 4), 4); }, "4 corners and 0 m");
  expect_refused([&] { clasp_targets(nan, 4); }, "point 3");
}

}  // namespace
}  // namespace graspless::geometry
