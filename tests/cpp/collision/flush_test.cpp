// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shapes that rest exactly on one another: our normal case, and where FCL's distances abort the
// process.
#include <vector>

#include <gtest/gtest.h>

#include "graspless/collision/world.hpp"

#include "collision/shapes.hpp"

namespace graspless::collision {
namespace {

using Eigen::Isometry3d;
using geometry::Shape;

constexpr int kInstances = 20000;
constexpr double kClear = 1e-5;  // beyond what World calls just touching [m]

/// A shape in a pose that rests on the plane z = 0, touching it at the origin or all around it.
struct Resting {
  const char* name;
  Shape shape;
  Isometry3d X_WB;
};

std::vector<Resting> resting_shapes() {
  const Isometry3d lying(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX()));
  return {
      {"box", geometry::Box{{0.1, 0.2, 0.06}}, translation(0, 0, 0.03)},
      {"sphere", geometry::Sphere{0.05}, translation(0, 0, 0.05)},
      {"standing capsule", geometry::Capsule{0.02, 0.1}, translation(0, 0, 0.07)},
      {"lying capsule", geometry::Capsule{0.02, 0.1}, translation(0, 0, 0.02) * lying},
      {"prism", geometry::Convex{prism(100, 0.06, 0.05).vertices}, translation(0, 0, 0.025)},
      {"triangle", geometry::Convex{prism(3, 0.06, 0.01).vertices}, translation(0, 0, 0.005)},
      {"mesh", dented_prism(8, 0.05, 0.05), translation(0, 0, 0.025)},
  };
}

Isometry3d turn_and_slide(std::mt19937& rng, double reach) {
  const double yaw = static_cast<int>(uniform(rng, 0, 3)) == 0 ? 0 : uniform(rng, -3.2, 3.2);
  const double x = uniform(rng, -reach, reach), y = uniform(rng, -reach, reach);
  return Eigen::Translation3d(x, y, 0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
}

/// The same shape hanging under the plane.
Isometry3d below(const Isometry3d& X_WB) {
  return Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()) * X_WB;
}

TEST(Flush, NothingDiesAndBothPathsAgree) {
  std::mt19937 rng(5);
  const std::vector<Resting> resting = resting_shapes();
  const auto instances = kInstances / static_cast<int>(resting.size() * resting.size());
  for (const Resting& over : resting) {
    for (const Resting& under : resting) {
      SCOPED_TRACE(std::string(over.name) + " on " + under.name);
      World world = two_bodies(over.shape, under.shape);
      for (int i = 0; i < instances; ++i) {
        // One in eight coincide altogether; the rest slide and turn on one another, anywhere in the
        // world.
        const Isometry3d X_VW = i % 2 == 0 ? Isometry3d::Identity() : random_pose(rng, 2);
        world.set_pose(0, X_VW * turn_and_slide(rng, 0.03) * over.X_WB);
        world.set_pose(1, i % 8 == 0 ? world.pose(0) : X_VW * below(under.X_WB));
        const bool collides = world.collides();
        if (!world.all_collisions().empty()) {
          EXPECT_TRUE(collides);
        }
      }
      EXPECT_EQ(world.num_failures(), 0);
    }
  }
}

TEST(Flush, AHairAboveIsFreeAndAHairBelowTouches) {
  std::mt19937 rng(6);
  const Shape slab = geometry::Box{{1, 1, 0.04}};
  for (const Resting& resting : resting_shapes()) {
    World world = two_bodies(resting.shape, slab);
    for (int i = 0; i < 300; ++i) {
      const Isometry3d X_VW = i % 2 == 0 ? Isometry3d::Identity() : random_pose(rng, 2);
      const Isometry3d X_WB = turn_and_slide(rng, 0.3) * resting.X_WB;
      world.set_pose(1, X_VW * translation(0, 0, -0.02));
      world.set_pose(0, X_VW * translation(0, 0, kClear) * X_WB);
      EXPECT_FALSE(world.collides()) << resting.name;
      EXPECT_TRUE(world.all_collisions().empty()) << resting.name;
      world.set_pose(0, X_VW * translation(0, 0, -kClear) * X_WB);
      EXPECT_TRUE(world.collides()) << resting.name;
      EXPECT_FALSE(world.all_collisions().empty()) << resting.name;
    }
    EXPECT_EQ(world.num_failures(), 0);
  }
}

TEST(Flush, FacesThatCoincideSideBySide) {
  const Shape cube = geometry::Box{{0.1, 0.1, 0.1}};
  const Shape brick = geometry::Convex{prism(4, 0.1, 0.1).vertices};
  for (const Shape& shape : {cube, brick}) {
    const double side = shape.index() == 0 ? 0.1 : 0.1 * std::sqrt(2);
    const Isometry3d X_WB(
        Eigen::AngleAxisd(shape.index() == 0 ? 0 : M_PI / 4, Eigen::Vector3d::UnitZ()));
    World world = two_bodies(shape, shape);
    world.set_pose(0, X_WB);
    for (const double gap : {-kClear, 0.0, kClear}) {
      world.set_pose(1, translation(side + gap, 0, 0) * X_WB);
      const bool collides = world.collides();
      if (gap != 0) {
        EXPECT_EQ(collides, gap < 0);
      }
    }
    EXPECT_EQ(world.num_failures(), 0);
  }
}

}  // namespace
}  // namespace graspless::collision
