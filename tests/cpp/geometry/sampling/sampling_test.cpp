// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "complaint.hpp"

namespace graspless::geometry {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

PlacedShape at(const Shape& shape, const Eigen::Vector3d& p_BG) {
  PlacedShape placed{shape};
  placed.X_BG.translation() = p_BG;
  return placed;
}

/// Squared distance of every point to its nearest, by looking at all.
Eigen::VectorXd nearest(const Eigen::Matrix3Xd& points) {
  Eigen::VectorXd squared(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    Eigen::RowVectorXd to = (points.colwise() - points.col(i)).colwise().squaredNorm();
    to[i] = std::numeric_limits<double>::infinity();
    squared[i] = to.minCoeff();
  }
  return squared;
}

double by_hand(const Eigen::Matrix3Xd& points) {
  const Eigen::VectorXd all = nearest(points);
  std::vector<double> squared(all.data(), all.data() + all.size());
  std::sort(squared.begin(), squared.end());
  return std::sqrt(squared[squared.size() / 2]);
}

TEST(SampleSurface, LiesOnASphereAndFillsItEvenly) {
  const Eigen::Matrix3Xd points = sample_surface({{Sphere{0.5}}}, 1500);
  ASSERT_EQ(points.cols(), 1500);
  EXPECT_LT((points.colwise().norm().array() - 0.5).abs().maxCoeff(), 1e-12);
  EXPECT_LT(points.rowwise().mean().norm(), 0.005);
  // The densest packing of discs would put them `apart`; random points come within a hundredth.
  const double apart = std::sqrt(2 / std::sqrt(3.0) * M_PI / 1500);
  const Eigen::VectorXd gaps = nearest(points).cwiseSqrt();
  EXPECT_GT(gaps.minCoeff(), 0.5 * apart);
  EXPECT_LT(gaps.maxCoeff(), 1.2 * apart);
}

TEST(SampleSurface, ManyPointsAreEvenToo) {
  constexpr int kCount = 100'001;
  const Eigen::Matrix3Xd points = sample_surface({{Sphere{0.5}}}, kCount);
  ASSERT_EQ(points.cols(), kCount);
  EXPECT_EQ(points, sample_surface({{Sphere{0.5}}}, kCount));
  EXPECT_LT((points.colwise().norm().array() - 0.5).abs().maxCoeff(), 1e-12);
  EXPECT_LT(points.rowwise().mean().norm(), 0.002);
  const double apart = std::sqrt(2 / std::sqrt(3.0) * M_PI / kCount);
  EXPECT_NEAR(spacing(points), 0.75 * apart, 0.15 * apart);
}

TEST(SampleSurface, CoversEveryFaceOfABoxByItsArea) {
  const Eigen::Vector3d size(0.3, 0.2, 0.1);
  const int count = 2200;
  const Eigen::Matrix3Xd points = sample_surface({{Box{size}}}, count);
  const double area = 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      const auto on_face = (points.row(axis).array() - side * size[axis]).abs() < 1e-12;
      const double share = size.prod() / size[axis] / area;
      EXPECT_NEAR(static_cast<double>(on_face.count()) / count, share, 0.1 * share);
    }
  }
}

TEST(SampleSurface, OfACapsuleLiesAtItsRadiusFromTheSegment) {
  PlacedShape capsule = at(Capsule{0.02, 0.3}, {1, 2, 3});
  capsule.X_BG.linear() = Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Matrix3Xd points = capsule.X_BG.inverse() * sample_surface({capsule}, 1000);
  int caps = 0;
  for (const auto& p : points.colwise()) {
    const double z = std::clamp(p.z(), -0.15, 0.15);
    EXPECT_NEAR((p - Eigen::Vector3d(0, 0, z)).norm(), 0.02, 1e-12);
    caps += std::abs(p.z()) > 0.15;
  }
  EXPECT_NEAR(caps / 1000.0, 0.04 / 0.34, 0.02);
}

TEST(SampleSurface, LeavesOutWhatIsInsideAnotherShape) {
  Eigen::Matrix3Xd octahedron(3, 6);
  octahedron << 1, -1, 0, 0, 0, 0,  //
      0, 0, 1, -1, 0, 0,            //
      0, 0, 0, 0, 1, -1;
  const std::vector<PlacedShape> shapes{
      at(Box{{1, 1, 1}}, {0, 0, 0}), at(Sphere{0.4}, {0.5, 0.5, 0.5}),
      at(Capsule{0.1, 1}, {0, 0, 0.5}), at(Convex{0.5 * octahedron}, {-0.6, 0, 0})};
  const Eigen::Matrix3Xd points = sample_surface(shapes, 3000);
  int others = 0;
  for (const auto& p : points.colwise()) {
    const Eigen::Vector3d to_sphere = p - Eigen::Vector3d(0.5, 0.5, 0.5);
    const double box = p.cwiseAbs().maxCoeff() - 0.5, sphere = to_sphere.norm() - 0.4;
    const double z = std::clamp(p.z(), 0.0, 1.0);
    const double capsule = (p - Eigen::Vector3d(0, 0, z)).norm() - 0.1;
    const double hull = (p - Eigen::Vector3d(-0.6, 0, 0)).lpNorm<1>() - 0.5;
    const double outside = std::min({box, sphere, capsule, hull / std::sqrt(3.0)});
    EXPECT_NEAR(outside, 0, 1e-9);
    others += box > 1e-9;
  }
  EXPECT_GT(others, 300);
}

TEST(SampleSurface, WhatLiesBetweenTwoTouchingBoxesIsNotSurface) {
  const Eigen::Matrix3Xd points =
      sample_surface({at(Box{{1, 1, 1}}, {0, 0, 0}), at(Box{{1, 1, 1}}, {0, 0, 1})}, 1500);
  for (const auto& p : points.colwise()) {
    EXPECT_FALSE(std::abs(p.z() - 0.5) < 1e-9 && p.head<2>().cwiseAbs().maxCoeff() < 0.499);
  }
}

TEST(SampleSurface, OfAMeshIsItsTrianglesOutsideTheOthers) {
  Mesh square;
  square.vertices.resize(3, 4);
  square.vertices << 0, 1, 1, 0,  //
      0, 0, 1, 1,                 //
      0, 0, 0, 0;
  square.triangles.resize(3, 2);
  square.triangles << 0, 0,  //
      1, 2,                  //
      2, 3;
  const std::vector<PlacedShape> hidden{{square}, at(Box{{3, 3, 1}}, {0, 0, 0.3})};
  const Eigen::Matrix3Xd outer = sample_surface(hidden, 1000);
  for (const auto& p : outer.colwise()) {
    EXPECT_FALSE(std::abs(p.z()) < 1e-12 && p.head<2>().cwiseAbs().maxCoeff() < 1.499);
  }
  const std::vector<PlacedShape> around{{square}, at(Sphere{0.1}, {0.5, 0.5, 0.05})};
  int inside = 0;
  const Eigen::Matrix3Xd pierced = sample_surface(around, 1000);
  for (const auto& p : pierced.colwise()) {
    inside += (p - Eigen::Vector3d(0.5, 0.5, 0.05)).norm() < 0.0999;
  }
  EXPECT_EQ(inside, 0);
  const Eigen::Matrix3Xd alone = sample_surface({{square}}, 500);
  EXPECT_EQ(alone.row(2).cwiseAbs().maxCoeff(), 0);
  EXPECT_GT(alone.topRows(2).minCoeff(), -1e-12);
  EXPECT_NEAR(alone.row(0).mean(), 0.5, 0.02);
}

TEST(SampleSurface, SameSeedSamePoints) {
  const std::vector<PlacedShape> shapes{{Box{{1, 1, 1}}}, at(Capsule{0.1, 2}, {0.3, 0, 0})};
  EXPECT_EQ(sample_surface(shapes, 300, 7), sample_surface(shapes, 300, 7));
  EXPECT_NE(sample_surface(shapes, 300, 7), sample_surface(shapes, 300, 8));
}

TEST(SampleSurface, SaysWhatIsWrong) {
  const std::vector<PlacedShape> ball{{Sphere{0.5}}};
  EXPECT_EQ(complaint([&] { sample_surface(ball, 0); }), "count must be in [1, 10000000], not 0");
  EXPECT_EQ(complaint([] { sample_surface({}, 10); }), "shapes must not be empty");
  expect_refused([] { sample_surface({{Sphere{1}}, {Sphere{-1}}}, 10); }, "shapes[1].shape.radius");
  PlacedShape skewed{Sphere{1}};
  skewed.X_BG.linear() *= 2;
  expect_refused([&] { sample_surface({skewed}, 10); }, "shapes[0].X_BG");
}

TEST(Spacing, IsTheMedianDistanceToTheNearest) {
  std::mt19937_64 rng(3);
  std::normal_distribution<double> normal;
  for (const int count : {2, 3, 10, 500, 1500}) {
    Eigen::Matrix3Xd points(3, count);
    for (double& value : points.reshaped()) value = normal(rng);
    points.row(2) *= 1e-3;
    points.leftCols(count / 3) *= 0.01;  // a dense part
    EXPECT_DOUBLE_EQ(spacing(points), by_hand(points)) << count;
  }
}

TEST(Spacing, FarPointsChangeNothing) {
  Eigen::Matrix3Xd points = sample_surface({{Sphere{0.01}}}, 1000);
  const double before = spacing(points);
  points.conservativeResize(3, 1002);
  points.col(1000) << 5000, 0, 0;
  points.col(1001) << 0, -5000, 100;
  EXPECT_NEAR(spacing(points), before, 0.01 * before);
}

TEST(Spacing, EqualPointsCountOnce) {
  Eigen::Matrix3Xd points(3, 6);
  points << 0, 0, 0, 1, 1, 1,  //
      0, 0, 0, 0, 0, 0,        //
      0, 0, 0, 0, 0, 0;
  EXPECT_EQ(spacing(points), 1);
  EXPECT_EQ(spacing(points.leftCols(3)), 0);
  EXPECT_EQ(spacing(Eigen::Matrix3Xd(3, 0)), 0);
  points(1, 4) = kNan;
  expect_refused([&] { spacing(points); }, "point 4");
}

TEST(Spacing, ManyEqualPointsChangeNothing) {
  const Eigen::Matrix3Xd cloud = sample_surface({{Sphere{0.5}}}, 2000);
  Eigen::Matrix3Xd more(3, 60000);  // half of them one point, which quadratic time would show
  more << cloud.replicate(1, 15), cloud.col(7).replicate(1, 30000);
  EXPECT_EQ(spacing(more), spacing(cloud));
}

TEST(Thin, KeepsOnePointOfEveryCell) {
  const Eigen::Matrix3Xd points = sample_surface({{Box{{0.3, 0.2, 0.1}}}}, 3000);
  const double cell = 0.021;
  const std::vector<int> kept = downsample(points, cell);
  const Eigen::Vector3d lower = points.rowwise().minCoeff();
  const auto cell_of = [&](int i) -> Eigen::Vector3i {
    return ((points.col(i) - lower) / cell).array().floor().cast<int>();
  };
  for (std::size_t k = 1; k < kept.size(); ++k) EXPECT_LT(kept[k - 1], kept[k]);
  for (int i = 0; i < 3000; ++i) {
    int in_cell = 0;
    for (const int k : kept) in_cell += cell_of(k) == cell_of(i);
    EXPECT_EQ(in_cell, 1) << i;
  }
}

TEST(Thin, KeepsThePointNearestToTheMean) {
  Eigen::Matrix3Xd points(3, 4);
  points << 0, 0.5, 0.9, 5,  //
      0, 0.1, 0, 0,          //
      0, 0, 0, 0;
  EXPECT_EQ(downsample(points, 1), (std::vector<int>{1, 3}));
  EXPECT_EQ(downsample(points, 100), (std::vector<int>{2}));
  EXPECT_EQ(downsample(points, 1e-3).size(), 4u);
  EXPECT_TRUE(downsample(Eigen::Matrix3Xd(3, 0), 1).empty());
  expect_refused([&] { downsample(points, 0); }, "cell must be in (0, 10000");
  points(2, 1) = kNan;
  expect_refused([&] { downsample(points, 1); }, "points must be within 10000 m of the origin");
}

TEST(VisiblePoints, OfASphereAreTheCapThatFacesTheViewer) {
  const Eigen::Matrix3Xd points = sample_surface({{Sphere{0.5}}}, 3000);
  const Eigen::Vector3d viewpoint(2, 1, -1);
  const std::vector<int> seen = visible_points(points, viewpoint);
  Eigen::VectorXi is_seen = Eigen::VectorXi::Zero(3000);
  for (const int i : seen) is_seen[i] = 1;
  int wrong = 0;
  for (int i = 0; i < 3000; ++i) {
    const double facing = points.col(i).dot(viewpoint - points.col(i));
    wrong += is_seen[i] != (facing > 0);
    EXPECT_FALSE(is_seen[i] == 1 && facing < -0.3) << i;
    EXPECT_FALSE(is_seen[i] == 0 && facing > 0.3) << i;
  }
  EXPECT_LT(wrong, 150);
}

TEST(VisiblePoints, AWallHidesWhatIsBehindIt) {
  const Eigen::Matrix3Xd points =
      sample_surface({at(Box{{0.4, 2, 2}}, {-0.2, 0, 0}), at(Sphere{0.3}, {-1, 0, 0})}, 4000);
  for (const int i : visible_points(points, {3, 0, 0})) EXPECT_GT(points(0, i), -0.15) << i;
}

TEST(VisiblePoints, FewPointsAreAllSeen) {
  Eigen::Matrix3Xd points(3, 3);
  points << 1, 0, 0,  //
      0, 1, 0,        //
      0, 0, 1;
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  EXPECT_EQ(visible_points(points, origin), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(visible_points(points.leftCols(1), origin), (std::vector<int>{0}));
  EXPECT_TRUE(visible_points(Eigen::Matrix3Xd(3, 0), origin).empty());
  expect_refused([&] { visible_points(points, points.col(1)); }, "viewpoint must not be one");
  points(0, 2) = kNan;
  expect_refused([&] { visible_points(points, origin); }, "point 2");
}

}  // namespace
}  // namespace graspless::geometry
