// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/openness.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "geometry/cycles/small_complexes.hpp"

namespace graspless::geometry {
namespace {

constexpr int kRays = 256;

/// Ray i of the Fibonacci spiral.
Eigen::Vector3d ray(int i) {
  const double z = 1 - (2 * i + 1.0) / kRays, r = std::sqrt(1 - z * z), turn = 2.39996322972865332;
  return {r * std::cos(turn * i), r * std::sin(turn * i), z};
}

/// True if p + t r, t > 0, meets a triangle of the complex: every ray against every triangle.
bool is_blocked(const Complex& complex, const Eigen::Vector3d& p, const Eigen::Vector3d& r) {
  for (const auto& t : complex.triangles.colwise()) {
    Eigen::Matrix3d corners = complex.points(Eigen::all, t);
    corners.colwise() -= p;
    const Eigen::Vector3d weights = corners.inverse() * r;  // of the corners, up to a factor
    if (weights.minCoeff() >= 0) return true;
  }
  return false;
}

Openness by_all_rays(const Complex& complex, const Eigen::Vector3d& p, const Eigen::Vector3d& n) {
  int open[2] = {0, 0}, all[2] = {0, 0};
  for (int i = 0; i < kRays; ++i) {
    const int side = ray(i).dot(n) > 0 ? 0 : 1;
    ++all[side];
    open[side] += is_blocked(complex, p, ray(i)) ? 0 : 1;
  }
  return {open[0] / static_cast<double>(all[0]), open[1] / static_cast<double>(all[1])};
}

/// Triangles of a given size about places at random distances.
Complex scattered(int count, double size, std::mt19937_64& rng) {
  std::uniform_real_distribution<double> u(-1, 1);
  const auto any = [&] { return Eigen::Vector3d(u(rng), u(rng), u(rng)); };
  Eigen::Matrix3Xd points(3, 3 * count);
  TriangleSet triangles;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d at = any();
    for (int k = 0; k < 3; ++k) points.col(3 * i + k) = at + size * any();
    triangles.insert({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return complex_of(points, {}, triangles);
}

TEST(Openness, CountsTheRaysThatMissEveryTriangle) {
  std::mt19937_64 rng(1);
  for (const double size : {0.02, 0.05, 0.1, 0.2, 0.4, 1.0}) {
    double blocked = 0;
    for (int trial = 0; trial < 10; ++trial) {
      const Complex complex = scattered(static_cast<int>(40 / size), size, rng);
      const Eigen::Vector3d p = 0.3 * complex.points.col(trial), n = complex.points.col(9);
      const Openness expected = by_all_rays(complex, p, n), found = openness(complex, p, n);
      blocked += 2 - expected.above - expected.below;
      EXPECT_EQ(found.above, expected.above);
      EXPECT_EQ(found.below, expected.below);
    }
    EXPECT_GT(blocked, 0);
  }
}

}  // namespace
}  // namespace graspless::geometry
