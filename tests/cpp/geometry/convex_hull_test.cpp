// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "graspless/geometry/sampling.hpp"

namespace graspless::geometry {
namespace {

/// Rings of corners with flat sides between them: four corners each, exactly in one plane or not
/// quite, as rounding has it.
Eigen::Matrix3Xd barrel() {
  constexpr int kRings = 9, kSectors = 18;
  Eigen::Matrix3Xd points(3, kRings * kSectors);
  for (int i = 0; i < kRings * kSectors; ++i) {
    const double polar = M_PI * (i / kSectors + 1) / (kRings + 1);
    const double around = 2 * M_PI * (i % kSectors) / kSectors;
    points.col(i) << 0.2 * std::cos(polar), 0.1 * std::sin(polar) * std::cos(around),
        0.1 * std::sin(polar) * std::sin(around);
  }
  return points;
}

/// All points of a 4 x 4 x 4 grid: most lie within a side, an edge or the inside of the hull.
Eigen::Matrix3Xd grid() {
  Eigen::Matrix3Xd points(3, 64);
  for (int i = 0; i < 64; ++i) points.col(i) << i / 16, i / 4 % 4, i % 4;
  return points;
}

Eigen::Matrix3Xd shuffled(const Eigen::Matrix3Xd& points, std::uint64_t seed) {
  std::vector<int> order(points.cols());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 rng(seed);
  std::shuffle(order.begin(), order.end(), rng);
  return points(Eigen::all, order);
}

/// Leaves the heap in another state than before.
void stir_the_heap(std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::vector<std::unique_ptr<char[]>> blocks;
  for (int i = 0; i < 3000; ++i) blocks.push_back(std::make_unique<char[]>(16 + rng() % 4096));
  std::shuffle(blocks.begin(), blocks.end(), rng);
}

TEST(ConvexHull, IsTheSameInAnyOrderOfPointsAndOnAnyHeap) {
  for (const Eigen::Matrix3Xd& points : {barrel(), grid()}) {
    const Mesh hull = convex_hull(points);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      stir_the_heap(seed);
      const Mesh again = convex_hull(shuffled(points, seed));
      ASSERT_EQ(again.vertices, hull.vertices);
      ASSERT_EQ(again.triangles, hull.triangles);
    }
  }
}

TEST(ConvexHull, OfAGridHasEightCornersAndTwelveTriangles) {
  const Mesh hull = convex_hull(grid());
  EXPECT_EQ(hull.vertices.cols(), 8);
  ASSERT_EQ(hull.triangles.cols(), 12);
  EXPECT_TRUE(is_convex(hull, hull));  // closed, and turned outward: it fills itself
  for (Eigen::Index i = 0; i < 12; ++i) {
    const Eigen::Vector3d a = hull.vertices.col(hull.triangles(0, i));
    const Eigen::Vector3d b = hull.vertices.col(hull.triangles(1, i));
    const Eigen::Vector3d c = hull.vertices.col(hull.triangles(2, i));
    EXPECT_GT((b - a).cross(c - a).dot(a - Eigen::Vector3d::Constant(1.5)), 0);
  }
}

TEST(ConvexHull, OfFlatPointsIsOneSide) {
  Eigen::Matrix3Xd points(3, 5);
  points << 0, 1, 1, 0, 0.5,  //
      0, 0, 1, 1, 0.5,        //
      0, 0, 0, 0, 0;
  const Mesh hull = convex_hull(points);
  EXPECT_EQ(hull.vertices.cols(), 4);
  EXPECT_EQ(hull.triangles.cols(), 2);
  EXPECT_EQ(convex_hull(points.leftCols(3)).triangles.cols(), 1);
}

TEST(ConvexHull, OfAPrismTakesNoQuadraticTime) {
  constexpr int kCorners = 20000;
  Eigen::Matrix3Xd points(3, 2 * kCorners);
  for (int i = 0; i < 2 * kCorners; ++i) {
    const double angle = 2 * M_PI * (i % kCorners) / kCorners;
    points.col(i) << std::cos(angle), std::sin(angle), i / kCorners;
  }
  const Mesh hull = convex_hull(shuffled(points, 1));
  EXPECT_EQ(hull.vertices.cols(), 2 * kCorners);
  EXPECT_EQ(hull.triangles.cols(), 4 * kCorners - 4);
  EXPECT_TRUE(is_convex(hull, hull));
}

TEST(ConvexHull, OfAPrismIsThatOfItsPointsAndOneInside) {
  Eigen::Matrix3Xd points(3, 13);
  for (int i = 0; i < 12; ++i) {
    points.col(i) << std::cos(i % 6), std::sin(i % 6), i / 6;
  }
  points.col(12) << 0.1, 0.1, 0.5;
  const Mesh prism = convex_hull(points.leftCols(12)), hull = convex_hull(points);
  EXPECT_EQ(prism.vertices, hull.vertices);
  EXPECT_EQ(prism.triangles, hull.triangles);
}

TEST(ConvexHull, OfManyPointsIsThatOfTheSameFewPoints) {
  const Eigen::Matrix3Xd few = barrel();
  const Mesh hull = convex_hull(few), of_many = convex_hull(few.replicate(1, 20));
  EXPECT_EQ(of_many.vertices, hull.vertices);
  EXPECT_EQ(of_many.triangles, hull.triangles);
}

TEST(SampleSurface, SameSeedSamePointsOnAnyHeap) {
  const std::vector<PlacedShape> shapes{{Convex{barrel()}}};
  const Eigen::Matrix3Xd points = sample_surface(shapes, 300, 7);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    stir_the_heap(seed);
    ASSERT_EQ(sample_surface(shapes, 300, 7), points);
  }
}

}  // namespace
}  // namespace graspless::geometry
