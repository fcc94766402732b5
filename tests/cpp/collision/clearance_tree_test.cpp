// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/clearance_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "graspless/watch.hpp"

#include "collision/shapes.hpp"

namespace graspless::collision {
namespace {

using Eigen::Vector3d;

Vector3d random_vector(std::mt19937& rng, double reach) {
  return {uniform(rng, -reach, reach), uniform(rng, -reach, reach), uniform(rng, -reach, reach)};
}

/// Triangles of many sizes. Every fifth is there twice.
std::vector<SurfaceTriangle> random_triangles(std::mt19937& rng, int count) {
  geometry::Mesh mesh;
  mesh.vertices.resize(3, 3 * count);
  mesh.triangles.resize(3, count);
  for (int i = 0; i < count; ++i) {
    const Vector3d a = random_vector(rng, 0.3);
    const double size = std::pow(10, uniform(rng, -4, 0));
    mesh.vertices.middleCols(3 * i, 3) << a, a + random_vector(rng, size),
        a + random_vector(rng, size);
    const int first = i % 5 == 4 ? 3 * (i - 1) : 3 * i;
    mesh.triangles.col(i) << first, first + 1, first + 2;
  }
  return surface_triangles(mesh);
}

double least_square(const std::vector<SurfaceTriangle>& triangles, const Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const SurfaceTriangle& triangle : triangles)
    least = std::min(least, squared_distance(triangle, point));
  return least;
}

TEST(ClearanceTree, FindsTheLeastDistanceFromAnyHint) {
  std::mt19937 rng(1);
  for (const int count : {1, 2, 3, 4, 5, 16, 17, 300}) {
    const auto triangles = random_triangles(rng, count);
    const ClearanceTree tree(triangles);
    for (int i = 0; i < 300; ++i) {
      const Vector3d point = random_vector(rng, i % 3 == 0 ? 10 : 0.4);
      const NearTriangle found = tree.nearest(point, static_cast<int>(rng() % triangles.size()));
      ASSERT_EQ(found.squared, least_square(triangles, point));
      ASSERT_EQ(found.squared, squared_distance(triangles[found.triangle], point));
      ASSERT_EQ(tree.distance(point, 100), std::sqrt(found.squared));
    }
  }
}

TEST(ClearanceTree, EndsAtATriangleThatIsNearEnough) {
  std::mt19937 rng(4);
  const auto triangles = random_triangles(rng, 300);
  const ClearanceTree tree(triangles);
  int ended = 0, searched = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d point = random_vector(rng, 0.4);
    const double least = least_square(triangles, point), enough = uniform(rng, 0, 2) * least;
    const NearTriangle found = tree.nearest(point, static_cast<int>(rng() % 300), enough);
    ASSERT_EQ(found.squared, squared_distance(triangles[found.triangle], point));
    if (least > enough) {
      ASSERT_EQ(found.squared, least);
      ++searched;
    } else {
      ASSERT_LE(found.squared, enough);
      ended += found.squared > least;
    }
  }
  EXPECT_GT(ended, 10);
  EXPECT_GT(searched, 300);
}

TEST(ClearanceTree, IsBuiltAnewAfterACallThatWasStopped) {
  std::mt19937 rng(3);
  const auto triangles = random_triangles(rng, 50000);
  const ClearanceTree tree(triangles);
  const Vector3d point = random_vector(rng, 0.3);
  {
    const Watch watch([] { throw Stop{}; });
    EXPECT_THROW(tree.distance(point, 1), Stop);
  }
  EXPECT_EQ(tree.distance(point, 1), std::sqrt(least_square(triangles, point)));
}

TEST(ClearanceTree, ServesThreadsFromTheFirstQueryOn) {
  std::mt19937 rng(2);
  const auto triangles = random_triangles(rng, 2000);
  const ClearanceTree tree(triangles);
  const Vector3d point = random_vector(rng, 0.3);
  std::vector<double> found(4);
  std::vector<std::thread> threads;
  for (double& distance : found) threads.emplace_back([&] { distance = tree.distance(point, 1); });
  for (std::thread& thread : threads) thread.join();
  for (const double distance : found)
    EXPECT_EQ(distance, std::sqrt(least_square(triangles, point)));
}

}  // namespace
}  // namespace graspless::collision
