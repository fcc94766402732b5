// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/one_sided.hpp"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "graspless/clasp/sample_objects.hpp"
#include "graspless/geometry/sampling.hpp"

#include "geometry/loops/views.hpp"

namespace graspless::geometry {
namespace {

TEST(OneSided, ALoopOfOneViewIsUncertainWithoutItsCamera) {
  const Loops one = shortest_loops(look(frame(), {kFront}).points);
  EXPECT_TRUE(one.found.empty());
  ASSERT_FALSE(one.uncertain.empty());
  EXPECT_NE(one.reason.find("one camera could have seen all points"), std::string::npos)
      << one.reason;
  LoopOptions options;
  options.all_sides = true;  // says who knows that it is so
  EXPECT_FALSE(shortest_loops(look(frame(), {kFront}).points, options).found.empty());
  const Eigen::Vector3d side(0.4, 0.2, 0.1);
  const std::vector<Eigen::Vector3d> around{kFront, -kFront, side, -side};
  const Loops all = shortest_loops(look(frame(), around).points);
  EXPECT_FALSE(all.found.empty()) << all.reason;
}

/// Points with noise of a part of their spacing in all directions.
Eigen::Matrix3Xd rough(Eigen::Matrix3Xd points, double part, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, part * spacing(points));
  for (double& value : points.reshaped()) value += noise(random);
  return points;
}

TEST(OneSided, NoiseDoesNotMakeTheLoopsOfOneViewHoles) {
  const Eigen::Vector3d side(0.4, 0.2, 0.1);
  const Eigen::Matrix3Xd one = look(frame(), {kFront}).points;
  const Eigen::Matrix3Xd all = look(frame(), {kFront, -kFront, side, -side}).points;
  for (const double part : {0.3, 0.5, 0.7}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      EXPECT_TRUE(is_one_sided(rough(one, part, seed))) << part << " " << seed;
      EXPECT_FALSE(is_one_sided(rough(all, part, seed))) << part << " " << seed;
    }
  }
}

/// The cloud without the points in three balls.
Eigen::Matrix3Xd patchy(const Eigen::Matrix3Xd& points, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<Eigen::Index> any(0, points.cols() - 1);
  const double radius = 3 * spacing(points);
  Eigen::Array<bool, 1, Eigen::Dynamic> stays;
  stays.setConstant(points.cols(), true);
  for (int ball = 0; ball < 3; ++ball) {
    const Eigen::Vector3d middle = points.col(any(random));
    stays = stays && (points.colwise() - middle).colwise().norm().array() > radius;
  }
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (stays[i]) kept.push_back(i);
  return points(Eigen::all, kept);
}

/// Neighbourhoods of 13 points go around the rods of a chair.
TEST(OneSided, RodsThatAreThinnerThanTheSpacingAreNoNoise) {
  const std::vector<PlacedShape> chair = clasp::sample_object("chair");
  for (const int count : {1000, 1500, 2000}) {
    const Eigen::Matrix3Xd cloud = sample_surface(chair, count);
    EXPECT_FALSE(is_one_sided(cloud)) << count;
    for (unsigned seed = 1; seed <= 5; ++seed)
      EXPECT_FALSE(is_one_sided(patchy(cloud, seed))) << count << " " << seed;
  }
}

}  // namespace
}  // namespace graspless::geometry
