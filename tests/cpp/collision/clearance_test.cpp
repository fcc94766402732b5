// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "collision/shapes.hpp"
#include "complaint.hpp"

namespace graspless::collision {
namespace {

using Eigen::Vector3d;
using geometry::Mesh;

double to_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const double square = (b - a).squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0;
  return (p - a - t * (b - a)).norm();
}

double to_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a);
  if (normal.norm() > 0) {
    const bool inside = (b - a).cross(p - a).dot(normal) >= 0 &&
                        (c - b).cross(p - b).dot(normal) >= 0 &&
                        (a - c).cross(p - c).dot(normal) >= 0;
    if (inside) return std::abs((p - a).dot(normal.normalized()));
  }
  return std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
}

/// By asking every triangle.
double brute_distance(const Mesh& mesh, const Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    const auto corners = mesh.triangles.col(i);
    least =
        std::min(least, to_triangle(p, mesh.vertices.col(corners[0]), mesh.vertices.col(corners[1]),
                                    mesh.vertices.col(corners[2])));
  }
  return least;
}

/// Triangles of all sizes, some as thin as a hair, some without any width.
Mesh random_soup(std::mt19937& rng, int count) {
  Mesh mesh;
  mesh.vertices.resize(3, 3 * count);
  mesh.triangles.resize(3, count);
  const auto draw = [&](double reach) {
    return Vector3d(uniform(rng, -reach, reach), uniform(rng, -reach, reach),
                    uniform(rng, -reach, reach));
  };
  for (int i = 0; i < count; ++i) {
    const Vector3d a = draw(0.3), b = a + draw(0.1);
    Vector3d c = a + draw(i % 3 == 0 ? 0.1 : 0.001);
    if (i % 7 == 0) c = a + uniform(rng, -1, 2) * (b - a);
    if (i % 11 == 0) c = a;
    mesh.vertices.middleCols(3 * i, 3) << a, b, c;
    mesh.triangles.col(i) << 3 * i, 3 * i + 1, 3 * i + 2;
  }
  return mesh;
}

Vector3d random_point(std::mt19937& rng, double reach) {
  return random_pose(rng, reach).translation();
}

TEST(Clearance, DistanceIsThatOfEveryTriangleAsked) {
  std::mt19937 rng(1);
  const Mesh mesh = random_soup(rng, 200);
  const Clearance clearance(mesh);
  for (const double reach : {0.4, 10.0, 5000.0}) {
    for (int i = 0; i < 1000; ++i) {
      const Vector3d p = random_point(rng, reach);
      ASSERT_NEAR(clearance.distance(p), brute_distance(mesh, p), 1e-9 + 1e-12 * reach);
    }
  }
}

TEST(Clearance, DistancesBeyondTheLimitAreInfinite) {
  std::mt19937 rng(2);
  const Mesh mesh = random_soup(rng, 300);
  const Clearance clearance(mesh);
  for (int i = 0; i < 500; ++i) {
    const Vector3d p(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1));
    const double limit = i % 10 == 0 ? 0 : uniform(rng, 0, 1), distance = clearance.distance(p);
    if (distance > limit) {
      EXPECT_TRUE(std::isinf(clearance.distance(p, limit))) << distance << " beyond " << limit;
    } else {
      EXPECT_NEAR(clearance.distance(p, limit), distance, 1e-12);
    }
    EXPECT_NEAR(clearance.distance(p, distance + 1e-9), distance, 1e-12);
  }
}

TEST(Clearance, TrianglesWithoutWidthAreSegmentsAndPoints) {
  Mesh mesh;
  mesh.vertices.resize(3, 3);
  mesh.vertices << 0, 1, 0.5, 0, 0, 0, 0, 0, 0;
  mesh.triangles.resize(3, 1);
  mesh.triangles << 0, 1, 2;
  EXPECT_NEAR(Clearance(mesh).distance({0.3, 0, 2}), 2, 1e-8);
  EXPECT_NEAR(Clearance(mesh).distance({3, 0, 0}), 2, 1e-8);
  mesh.triangles << 1, 1, 1;
  EXPECT_NEAR(Clearance(mesh).distance({1, 3, 0}), 3, 1e-8);
}

/// Bounds that the threshold does not end at a larger cell.
Clearance::Bounds of_cell(Clearance& clearance, const Vector3d& p) {
  return clearance.rough_bounds(p, clearance.distance(p));
}

TEST(Clearance, BoundsEncloseTheDistanceAndLieACellApart) {
  std::mt19937 rng(2);
  const Mesh mesh = random_soup(rng, 100);
  for (const double cell : {0.002, 0.01, 0.3}) {
    Clearance clearance(mesh, cell);
    for (int i = 0; i < 3000; ++i) {
      const Vector3d p = random_point(rng, i % 2 == 0 ? 0.4 : 3);
      const double distance = clearance.distance(p);
      const auto bounds = of_cell(clearance, p);
      ASSERT_LE(bounds.lower, distance);
      ASSERT_GE(bounds.upper, distance);
      ASSERT_GE(bounds.lower, 0);
      ASSERT_LE(bounds.upper - bounds.lower, std::sqrt(3.0) * cell + 1e-6);
    }
  }
}

TEST(Clearance, ThresholdIsAlwaysToldFromTheDistance) {
  std::mt19937 rng(3);
  const Mesh mesh = random_soup(rng, 100);
  const double cell = 0.02;
  Clearance clearance(mesh, cell);
  int finer = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector3d p = random_point(rng, 0.4);
    const double threshold = uniform(rng, 0, 0.1);
    const auto rough = of_cell(clearance, p);
    const auto bounds = clearance.bounds(p, threshold);
    const double distance = clearance.distance(p);
    ASSERT_LE(bounds.lower, distance + 1e-12);
    ASSERT_GE(bounds.upper, distance - 1e-12);
    const bool open = bounds.lower <= threshold && threshold <= bounds.upper;
    ASSERT_FALSE(open);
    if (bounds.lower > threshold) {
      ASSERT_LE(distance - threshold, 8 * (bounds.lower - threshold) + 1e-12);
    }
    finer += rough.lower <= threshold && threshold <= rough.upper;
  }
  EXPECT_GT(finer, 200);
}

TEST(Clearance, HasNoEnd) {
  std::mt19937 rng(4);
  const Mesh mesh = random_soup(rng, 50);
  Clearance clearance(mesh, 0.01);
  for (const double far : {1e3, 1.04e4, 1.05e4, 1e6, 1e12}) {
    for (const Vector3d& p : {Vector3d(far, 0, 0), Vector3d(0, -far, far)}) {
      const auto bounds = of_cell(clearance, p);
      EXPECT_NEAR(clearance.distance(p), p.norm(), 1);
      EXPECT_LE(bounds.lower, clearance.distance(p));
      EXPECT_GE(bounds.upper, clearance.distance(p));
      EXPECT_LE(bounds.upper - bounds.lower, 0.02 + 1e-6 * far);
    }
  }
}

TEST(Clearance, BoundsDoNotDependOnWhatWasAskedBefore) {
  std::mt19937 rng(5);
  const Mesh mesh = random_soup(rng, 100);
  Clearance used(mesh, 0.002);
  for (int i = 0; i < 20000; ++i) used.bounds(random_point(rng, 2), 0.1);
  Clearance fresh = used;
  for (int i = 0; i < 200; ++i) {
    const Vector3d p = random_point(rng, 0.4);
    EXPECT_EQ(of_cell(used, p).lower, of_cell(fresh, p).lower);
  }
  Clearance copy = used.with_cells();
  for (const double reach : {0.4, 2.0}) {
    for (int i = 0; i < 200; ++i) {
      const Vector3d p = random_point(rng, reach);
      EXPECT_EQ(of_cell(copy, p).upper, of_cell(used, p).upper);
      EXPECT_EQ(copy.bounds(p, 0.1).lower, used.bounds(p, 0.1).lower);
    }
  }
}

TEST(Clearance, ForgetsWhenTheGridGrowsTooLarge) {
  Clearance clearance(prism(8, 0.1, 0.2), 0.001);
  for (int i = 0; i < 40000; ++i) {
    const Vector3d p(0.008 * (i % 200), 0.008 * (i / 200), 0.3);
    const auto bounds = of_cell(clearance, p);
    ASSERT_LE(bounds.lower, bounds.upper);
  }
  const Vector3d p(0.1234, 0.2, 0.3);
  EXPECT_LE(of_cell(clearance, p).lower, clearance.distance(p));
}

TEST(Clearance, CopiesServeThreads) {
  std::mt19937 rng(6);
  const Mesh mesh = random_soup(rng, 300);
  const Clearance original(mesh);
  std::vector<Vector3d> points;
  for (int i = 0; i < 500; ++i) points.push_back(random_point(rng, 0.4));
  std::vector<std::vector<double>> lower(3);
  std::vector<std::thread> threads;
  for (auto& mine : lower) {
    threads.emplace_back([&mine, &points, copy = original]() mutable {
      for (const Vector3d& p : points) mine.push_back(of_cell(copy, p).lower);
    });
  }
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(lower[0], lower[1]);
  EXPECT_EQ(lower[0], lower[2]);
}

TEST(Clearance, RefusesNonsense) {
  const Mesh mesh = prism(5, 0.1, 0.1);
  expect_refused([] { Clearance(Mesh{}); }, "mesh.triangles must not be empty");
  expect_refused([&] { Clearance(mesh, 0); }, "cell must be in (0, ");
  expect_refused([&] { Clearance(mesh, std::nan("")); }, "cell must be in (0, ");
  Clearance clearance(mesh);
  const Vector3d nowhere(0, std::nan(""), 0);
  expect_refused([&] { clearance.distance(nowhere); }, "point must be finite");
  expect_refused([&] { clearance.bounds(nowhere, 0.1); }, "point must be finite");
}

}  // namespace
}  // namespace graspless::collision
