// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/point_cloud.hpp"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "complaint.hpp"
#include "geometry/polygons.hpp"

namespace graspless::geometry {
namespace {

TEST(Outline, OfAGridIsNearlyThePolygon) {
  const double spacing = 0.006;
  std::mt19937_64 rng(1);
  for (const Polygon& polygon : {square(0.1), l_shape()}) {
    const Eigen::Matrix2Xd points = sample_grid(polygon, spacing);
    const Polygon around = outline(points);
    for (const auto& p : points.colwise()) EXPECT_GT(around.depth(p), -spacing / 2);
    for (const auto& v : around.vertices().colwise())
      EXPECT_LT(std::abs(polygon.depth(v)), spacing);
  }
}

TEST(Outline, OfScatteredPointsHoldsThemAll) {
  std::mt19937_64 rng(2);
  for (int i = 0; i < 50; ++i) {
    const Polygon polygon = l_shape();
    std::vector<Eigen::Vector2d> inside;
    while (inside.size() < 300) {
      const Eigen::Vector2d p = random_point(polygon, rng);
      if (polygon.contains(p)) inside.push_back(p);
    }
    const Polygon around = outline(columns(inside));
    for (const auto& p : inside) EXPECT_GT(around.depth(p), -0.1);  // sparse points, simplified
  }
}

TEST(Outline, IsUnchangedByRepeatedPoints) {
  const Eigen::Matrix2Xd points = sample_grid(square(0.1), 0.01);
  Eigen::Matrix2Xd twice(2, 2 * points.cols());
  twice << points, points;
  EXPECT_NEAR(outline(twice).area(), outline(points).area(), 1e-12);
}

TEST(Outline, DoesNotDependOnWhereMemoryLies) {
  const Eigen::Matrix2Xd points = sample_grid(l_shape(), 0.013);
  const Eigen::Matrix2Xd first = outline(points).vertices();
  std::vector<std::vector<char>> elsewhere;
  for (std::size_t i = 1; i < 40; ++i) {
    elsewhere.emplace_back(i * 997);  // moves what is allocated next
    EXPECT_EQ(outline(points).vertices(), first);
    if (i % 3 == 0) elsewhere.erase(elsewhere.begin());
  }
}

// Alpha shapes of few points often touch themselves at a point.
TEST(Outline, DoesNotDependOnTheOrderOfThePoints) {
  std::mt19937_64 rng(4);
  const Polygon polygon = l_shape();
  for (int i = 0; i < 100; ++i) {
    std::vector<Eigen::Vector2d> points;
    while (points.size() < 60) points.push_back(random_point(polygon, rng));
    const Polygon around = outline(columns(points));
    std::shuffle(points.begin(), points.end(), rng);
    EXPECT_EQ(outline(columns(points)).vertices(), around.vertices());
  }
}

TEST(Outline, FillsHoles) {
  std::vector<Eigen::Vector2d> ring;
  for (int i = 0; i < 120; ++i) {
    for (double r : {0.04, 0.045, 0.05}) {
      ring.emplace_back(r * std::cos(2 * M_PI * i / 120), r * std::sin(2 * M_PI * i / 120));
    }
  }
  EXPECT_TRUE(outline(columns(ring)).contains({0, 0}));
}

TEST(Outline, RefusesPointsWithoutArea) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(outline(columns({{0, 0}, {1, 0}})), std::invalid_argument);
  EXPECT_THROW(outline(columns({{0, 0}, {1, 1}, {2, 2}, {3, 3}})), std::invalid_argument);
  EXPECT_THROW(outline(columns({{0, 0}, {1, 0}, {0, nan}})), std::invalid_argument);
  EXPECT_THROW(outline(Eigen::Matrix2Xd(2, 0)), std::invalid_argument);
}

TEST(Outline, AcceptsPointsThatAreAlmostOnALine) {
  const double t = std::numeric_limits<double>::denorm_min();  // 0.5 * t is 0
  const Polygon around =
      outline(columns({{0.5, -1}, {0.125, 2 * t}, {0.875, 3 * t}, {0.875, t}, {0.625, 2 * t}}));
  EXPECT_NEAR(around.area(), 0.375, 1e-6);
  EXPECT_THROW(outline(columns({{0, 0}, {1e-200, 0}, {0, 1e-200}})), std::invalid_argument);
}

TEST(Outline, OfATurnedGridIsThatOfTheGrid) {
  const Eigen::Matrix2Xd points = sample_grid(square(0.1), 0.005);
  for (int i = 1; i < 40; ++i) {
    const Polygon around = outline(Eigen::Rotation2Dd(0.04 * i).toRotationMatrix() * points);
    EXPECT_NEAR(around.area(), square(0.095).area(), 5e-4) << i;
  }
}

TEST(Outline, RefusesStrayPoints) {
  const Eigen::Matrix2Xd points = sample_grid(square(0.1), 0.005);
  const double spacing = points(1, 1) - points(1, 0), corner = points.maxCoeff();
  const auto beside = [&](int count, double spacings) {
    Eigen::Matrix2Xd all(2, points.cols() + count);
    all << points, Eigen::Vector2d(corner + spacings * spacing, 0).replicate(1, count);
    for (int i = 0; i < count; ++i) all(1, points.cols() + i) = i * spacing;
    return all;
  };
  expect_refused([&] { outline(beside(1, 7)); }, "points have 1 stray point, more");
  expect_refused([&] { outline(beside(3, 30)); }, "have 3 stray points, more than");
  expect_refused([&] { outline(beside(20, 30)); }, "points are not one piece");
  EXPECT_GT(outline(beside(1, 5)).area(), outline(points).area());
}

TEST(SampleGrid, LiesInsideAndIsNeverEmpty) {
  const Eigen::Matrix2Xd grid = sample_grid(l_shape(), 0.02);
  for (const auto& p : grid.colwise()) EXPECT_TRUE(l_shape().contains(p));
  EXPECT_NEAR(static_cast<double>(grid.cols()) * 0.02 * 0.02, l_shape().area(), 0.02);
  EXPECT_EQ(sample_grid(l_shape(), 100).cols(), 1);
  EXPECT_THROW(sample_grid(l_shape(), 0), std::invalid_argument);
}

}  // namespace
}  // namespace graspless::geometry
