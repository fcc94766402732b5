// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/watch.hpp"

#include <atomic>
#include <cmath>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "graspless/clasp/object.hpp"
#include "graspless/collision/solid.hpp"
#include "graspless/fingertip/object.hpp"
#include "graspless/geometry/band.hpp"
#include "graspless/geometry/complex.hpp"
#include "graspless/geometry/point_cloud.hpp"
#include "graspless/slide/problem.hpp"

#include "once.hpp"

namespace graspless {
namespace {

/// True if the work polls: a check that always ends it does so.
template <class Work>
bool can_be_ended(const Work& work) {
  const Watch watch([] { throw Stop{}; });
  try {
    work();
    return false;
  } catch (const Stop&) {
    return true;
  }
}

/// A round outline whose corners lie at random distances, so that every second one is reflex.
Eigen::Matrix2Xd rough_circle(int corners) {
  std::mt19937_64 rng(1);
  std::uniform_real_distribution<double> radius(0.3, 0.3003);
  Eigen::Matrix2Xd outline(2, corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners, r = radius(rng);
    outline.col(i) << r * std::cos(angle), r * std::sin(angle);
  }
  return outline;
}

Eigen::Matrix3Xd random_points(int count) {
  std::mt19937_64 rng(1);
  std::normal_distribution<double> normal;
  Eigen::Matrix3Xd points(3, count);
  for (double& value : points.reshaped()) value = normal(rng);
  return points;
}

TEST(Watch, EndsALoop) {
  EXPECT_TRUE(can_be_ended([] {
    for (;;) poll();
  }));
}

TEST(Watch, CallsTheChecksOfAllThatLive) {
  int outer = 0, inner = 0;
  const Watch first([&] { ++outer; });
  {
    const Watch second([&] { ++inner; });
    while (inner < 2) poll();
  }
  EXPECT_GE(outer, 2);
  while (outer < 5) poll();
  EXPECT_LE(inner, outer - 2);
}

TEST(Watch, BelongsToItsThread) {
  const Watch watch([] { throw Stop{}; });
  std::thread([] {
    int calls = 0;
    const Watch own([&] { ++calls; });
    while (calls < 2) poll();
  }).join();
}

TEST(Once, WorkThatIsEndedIsDoneAnew) {
  Once once;
  int done = 0;
  EXPECT_TRUE(can_be_ended([&] {
    once([] {
      for (;;) poll();
    });
  }));
  for (int i = 0; i < 3; ++i) once([&] { ++done; });
  EXPECT_EQ(done, 1);
}

TEST(Once, WhoWaitsCanBeEnded) {
  Once once;
  std::atomic<bool> has_begun{false}, may_end{false};
  std::thread other([&] {
    once([&] {
      has_begun = true;
      while (!may_end) std::this_thread::yield();
    });
  });
  while (!has_begun) std::this_thread::yield();
  int done = 0;
  EXPECT_TRUE(can_be_ended([&] { once([&] { ++done; }); }));
  may_end = true;
  once([&] { ++done; });  // waits
  EXPECT_EQ(done, 0);
  other.join();
}

TEST(Watch, EndsPolygonsOfManyCorners) {
  const geometry::Polygon rough(rough_circle(4000));
  EXPECT_TRUE(can_be_ended([&] { geometry::Band(rough, 0.06); }));
  EXPECT_TRUE(can_be_ended([&] { geometry::sample_grid(rough, 5e-4); }));
  const Eigen::Isometry3d X_WS = Eigen::Isometry3d::Identity();
  EXPECT_TRUE(can_be_ended([&] { slide::Support(rough, X_WS, 0.04, 0.06, 0.3); }));
}

TEST(Watch, EndsClouds) {
  const Eigen::Matrix3Xd points = random_points(50000);
  EXPECT_TRUE(can_be_ended([&] { geometry::Filtration(points, "points"); }));
  geometry::LoopOptions options;
  options.max_points = 100000;
  EXPECT_TRUE(can_be_ended([&] { clasp::Object::from_cloud("cloud", points, options); }));
}

TEST(Watch, EndsHullsOfManyCoplanarPoints) {
  Eigen::Matrix3Xd points(3, 8000);
  points.topRows<2>() << rough_circle(4000), 2 * rough_circle(4000);
  points.row(2) << Eigen::RowVectorXd::Zero(4000), Eigen::RowVectorXd::Ones(4000);
  points.topRows<2>().colwise().normalize();
  points.rightCols<4000>() *= 2;  // a cone: no prism
  EXPECT_TRUE(can_be_ended([&] {
    collision::Solid({{geometry::Convex{points}, Eigen::Isometry3d::Identity()}}, "cone");
  }));
}

}  // namespace
}  // namespace graspless
