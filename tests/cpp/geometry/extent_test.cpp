// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {
namespace {

Eigen::Isometry3d random_pose(std::mt19937_64& rng) {
  std::normal_distribution<double> n;
  const Eigen::Quaterniond q(n(rng), n(rng), n(rng), n(rng));
  return Eigen::Translation3d(n(rng), n(rng), n(rng)) * q.normalized();
}

TEST(Extent, OfABoxIsItsFarthestCorner) {
  std::mt19937_64 rng(1);
  for (int i = 0; i < 200; ++i) {
    const PlacedShape box{Box{{0.2, 0.4, 0.6}}, random_pose(rng)};
    Eigen::Matrix3Xd corners(3, 8);
    for (int c = 0; c < 8; ++c) {
      corners.col(c) << (c & 1 ? 0.1 : -0.1), (c & 2 ? 0.2 : -0.2), (c & 4 ? 0.3 : -0.3);
    }
    const Eigen::Vector3d d = random_pose(rng).linear().col(0);
    const double expected = (d.transpose() * (box.X_BG * corners).eval()).maxCoeff();
    EXPECT_NEAR(extent(box, d), expected, 1e-12);
    EXPECT_NEAR(extent({Convex{corners}, box.X_BG}, d), expected, 1e-12);
  }
}

TEST(Extent, OfACapsuleIsThatOfItsEndSpheres) {
  std::mt19937_64 rng(2);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Isometry3d X = random_pose(rng);
    const Eigen::Vector3d d = random_pose(rng).linear().col(1);
    const PlacedShape upper{Sphere{0.1}, X * Eigen::Translation3d(0, 0, 0.25)};
    const PlacedShape lower{Sphere{0.1}, X * Eigen::Translation3d(0, 0, -0.25)};
    EXPECT_NEAR(extent({Capsule{0.1, 0.5}, X}, d), std::max(extent(upper, d), extent(lower, d)),
                1e-12);
  }
}

TEST(Extent, OfNothingIsMinusInfinity) {
  const double none = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(extent({Mesh{}, Eigen::Isometry3d::Identity()}, Eigen::Vector3d::UnitX()), none);
  EXPECT_EQ(extent({Convex{}, Eigen::Isometry3d::Identity()}, Eigen::Vector3d::UnitX()), none);
}

}  // namespace
}  // namespace graspless::geometry
