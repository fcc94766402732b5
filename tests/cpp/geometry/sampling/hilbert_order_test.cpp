// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sampling/hilbert_order.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace graspless::geometry {
namespace {

/// Length of the way through all points in an order.
double way(const Eigen::Matrix3Xd& points, const std::vector<int>& order) {
  double length = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
    length += (points.col(order[i]) - points.col(order[i - 1])).norm();
  return length;
}

TEST(MortonOrder, HoldsEveryPointOnceAndNeighboursNearEachOther) {
  std::mt19937_64 rng(1);
  std::uniform_real_distribution<double> u(-0.4, 0.6);
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::NullaryExpr(3, 4096, [&] { return u(rng); });
  std::vector<int> all(4096);
  std::iota(all.begin(), all.end(), 0);
  std::vector<int> order = morton_order(points);
  EXPECT_LT(way(points, order), 0.2 * way(points, all));  // a cube of 16 x 16 x 16: about 1/16
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, all);
}

TEST(MortonOrder, KeepsTheOrderOfEqualPoints) {
  std::mt19937_64 rng(2);
  std::uniform_int_distribution<int> u(0, 2);
  const Eigen::Matrix3Xd points =
      Eigen::Matrix3Xd::NullaryExpr(3, 200, [&] { return static_cast<double>(u(rng)); });
  const std::vector<int> order = morton_order(points);
  int equal = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      if (points.col(order[i]) != points.col(order[k])) continue;
      EXPECT_LT(order[i], order[k]);
      ++equal;
    }
  }
  EXPECT_GT(equal, 100);
  EXPECT_EQ(morton_order(Eigen::Matrix3Xd::Ones(3, 3)), (std::vector<int>{0, 1, 2}));
}

}  // namespace
}  // namespace graspless::geometry
