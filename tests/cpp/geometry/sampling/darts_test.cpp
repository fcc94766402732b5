// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sampling/darts.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace graspless::geometry {
namespace {

/// Random points of the unit square in the plane z = x.
Eigen::Matrix3Xd random_points(int count) {
  std::mt19937_64 rng(1);
  std::uniform_real_distribution<double> side(0, 1);
  Eigen::Matrix3Xd points(3, count);
  for (auto p : points.colwise()) {
    p << side(rng), side(rng), 0;
    p.z() = p.x();
  }
  return points;
}

TEST(ThrowDarts, KeepsPointsThatAreSpreadEvenly) {
  constexpr int kCount = 1000;
  const Eigen::Matrix3Xd points = in_cell_order(random_points(5 * kCount));
  const std::vector<int> kept = throw_darts(points, kCount, std::sqrt(2));
  ASSERT_EQ(kept.size(), 1000u);
  const double side = std::sqrt(std::sqrt(2) / kCount);  // of the square of one point [m]
  double nearest = 1, farthest = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    double least = 1;
    for (const int k : kept) {
      if (k == i) continue;
      const double distance = (points.col(k) - points.col(i)).norm();
      least = std::min(least, distance);
      if (std::binary_search(kept.begin(), kept.end(), static_cast<int>(i)))
        nearest = std::min(nearest, distance);
    }
    farthest = std::max(farthest, least);
  }
  EXPECT_GT(nearest, 0.6 * side);
  EXPECT_LT(farthest, 1.6 * side);
}

TEST(ThrowDarts, OnTwoSidesOfAThinSheetTooKeepsTheCount) {
  Eigen::Matrix3Xd points = random_points(10000);
  for (int i = 0; i < 5000; ++i) points(2, i) += 1e-6;
  EXPECT_EQ(throw_darts(points, 2000, 2 * std::sqrt(2)).size(), 2000u);
}

TEST(ThrowDarts, EqualPointsAreKeptIfThereAreNoOthers) {
  EXPECT_EQ(throw_darts(Eigen::Matrix3Xd::Zero(3, 50), 10, 1).size(), 10u);
}

TEST(InCellOrder, IsAPermutation) {
  const Eigen::Matrix3Xd points = random_points(500), sorted = in_cell_order(points);
  EXPECT_LT((sorted.rowwise().sum() - points.rowwise().sum()).norm(), 1e-9);
  const double before = (points.rightCols(499) - points.leftCols(499)).colwise().norm().sum();
  const double now = (sorted.rightCols(499) - sorted.leftCols(499)).colwise().norm().sum();
  EXPECT_LT(now, before / 2);
}

}  // namespace
}  // namespace graspless::geometry
