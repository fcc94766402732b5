// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/overlap.hpp"

#include <gtest/gtest.h>

#include "collision/shapes.hpp"

namespace graspless::collision {
namespace {

TEST(Overlap, IsTheShortestWayOut) {
  World world = two_bodies(geometry::Box{{1, 1, 1}}, geometry::Box{{1, 1, 1}});
  for (const double deep : {0.0004, 0.002, 0.03, 0.4}) {
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d p = (1 - deep) * Eigen::Vector3d::Unit(axis);
      world.set_pose(1, translation(p.x(), p.y(), p.z()));
      EXPECT_NEAR(overlap(world, 0, 1), deep, 0.03 * deep + 1e-4);
      EXPECT_NEAR(overlap(world, 1, 0), deep, 0.03 * deep + 1e-4);
      EXPECT_EQ(world.pose(1).translation(), p);
    }
  }
  world.set_pose(1, translation(0, 0, 1.01));
  EXPECT_EQ(overlap(world, 0, 1), 0);
  world.set_pose(1, translation(0, 0, 0.9));
  world.remove_pair(0, 1);
  EXPECT_EQ(overlap(world, 0, 1), 0);
}

TEST(Overlap, IsAtMost15PercentTooLong) {
  World world = two_bodies(geometry::Sphere{0.5}, geometry::Sphere{0.5});
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d direction = Eigen::Vector3d::Random().normalized();
    const Eigen::Vector3d p = 0.9 * direction;
    world.set_pose(1, translation(p.x(), p.y(), p.z()));
    const double found = overlap(world, 0, 1);
    EXPECT_GE(found, 0.1 - 1e-6);
    EXPECT_LE(found, 0.115 * 1.03);
  }
}

TEST(Overlap, EndsWhereNoTranslationHelps) {
  World world = two_bodies(geometry::Box{{20, 20, 20}}, geometry::Sphere{0.5});
  EXPECT_EQ(overlap(world, 0, 1), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace graspless::collision
