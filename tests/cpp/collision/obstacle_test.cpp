// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/obstacle.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "graspless/collision/world.hpp"

#include "../complaint.hpp"
#include "geometry/box_mesh.hpp"
#include "geometry/directions.hpp"

namespace graspless::collision {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d;
using geometry::PlacedShape;

const Isometry3d kAside =
    Eigen::Translation3d(0.4, -0.2, 0.1) * Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized());

geometry::Mesh block() { return geometry::box_mesh({0.3, 0.2, 0.15}); }

std::vector<PlacedShape> shapes() {
  geometry::Convex wedge;
  wedge.vertices = block().vertices;
  return {{geometry::Box{{0.1, 0.2, 0.3}}, kAside},
          {geometry::Sphere{0.07}, kAside},
          {geometry::Capsule{0.03, 0.2}, kAside},
          {wedge, kAside},
          {block(), kAside}};
}

double extent(const std::vector<PlacedShape>& parts, const Vector3d& direction) {
  double most = -1e9;
  for (const PlacedShape& part : parts) most = std::max(most, geometry::extent(part, direction));
  return most;
}

TEST(Obstacle, GrowsByItsPaddingInEveryDirection) {
  const double most[] = {1.74, 1 + 1e-9, 1 + 1e-9, 1.26, 1.26};
  int i = 0;
  for (const PlacedShape& shape : shapes()) {
    const Obstacle obstacle{"thing", {shape}, Isometry3d::Identity(), 0.02};
    for (int k = 0; k < 500; ++k) {
      const Vector3d direction = geometry::spread_direction(k, 500);
      const double added = extent(obstacle.grown(), direction) - geometry::extent(shape, direction);
      EXPECT_GE(added, 0.02 - 1e-12) << "shape " << i;
      EXPECT_LE(added, most[i] * 0.02) << "shape " << i;
    }
    ++i;
  }
}

/// A pin that touches what is at a point.
bool touches(const std::vector<PlacedShape>& body, const Vector3d& p) {
  World world;
  const int pin = world.add_body("pin", {{geometry::Sphere{1e-5}, Isometry3d::Identity()}});
  world.add_pair(world.add_body("body", body), pin);
  world.set_pose(pin, Isometry3d(Eigen::Translation3d(p)));
  return world.collides();
}

// A mesh that is not convex: the notch of an L stays open, and its inside stays solid.
TEST(Obstacle, KeepsTheNotchOfAMeshOpen) {
  geometry::Mesh ell;  // an L, 0.3 long and 0.1 wide and high
  const double ring[6][2] = {{0, 0}, {0.3, 0}, {0.3, 0.1}, {0.1, 0.1}, {0.1, 0.3}, {0, 0.3}};
  ell.vertices.resize(3, 12);
  for (int i = 0; i < 6; ++i) {
    ell.vertices.col(i) << ring[i][0], ring[i][1], 0;
    ell.vertices.col(6 + i) << ring[i][0], ring[i][1], 0.1;
  }
  std::vector<Eigen::Vector3i> faces{{0, 2, 1}, {0, 3, 2}, {0, 4, 3},  {0, 5, 4},
                                     {6, 7, 8}, {6, 8, 9}, {6, 9, 10}, {6, 10, 11}};
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    faces.push_back({i, j, 6 + j});
    faces.push_back({i, 6 + j, 6 + i});
  }
  ell.triangles.resize(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t i = 0; i < faces.size(); ++i) ell.triangles.col(i) = faces[i];
  const Obstacle obstacle{"ell", {{ell, Isometry3d::Identity()}}, Isometry3d::Identity(), 0.02};
  const auto grown = obstacle.grown();
  EXPECT_TRUE(touches(grown, {0.05, 0.05, 0.05}));   // inside
  EXPECT_TRUE(touches(grown, {0.05, 0.05, 0.119}));  // above the top
  EXPECT_TRUE(touches(grown, {0.119, 0.2, 0.05}));   // in the notch, near a wall
  EXPECT_FALSE(touches(grown, {0.127, 0.2, 0.05}));
  EXPECT_FALSE(touches(grown, {0.2, 0.2, 0.05}));
  EXPECT_FALSE(touches(grown, {0.05, 0.05, 0.127}));
}

TEST(Obstacle, TellsItsPadding) {
  Obstacle cup{"cup", {{geometry::Sphere{0.1}, kAside}}, Isometry3d::Identity()};
  EXPECT_EQ(cup.label(), "cup");
  EXPECT_EQ(cup.grown().size(), 1u);
  cup.padding = 0.0125;
  EXPECT_EQ(cup.label(), "cup (padding 12.5 mm)");
}

TEST(Obstacle, KeepsTheSolidsOfPaddedMeshes) {
  const Obstacle thing{"thing", {{block(), kAside}, {geometry::Sphere{0.1}, kAside}}, kAside, 0.01};
  const auto* first = &thing.solid().data();
  Obstacle other = thing;
  other.name = "other";
  EXPECT_EQ(&other.solid().data(), first);
  other.padding = 0.02;
  EXPECT_NE(&other.solid().data(), first);
  other = thing;
  other.shapes[0].X_BG = Isometry3d::Identity();
  EXPECT_NE(&other.solid().data(), first);
  other = thing;
  other.shapes[1].shape = geometry::Sphere{0.11};
  EXPECT_NE(&other.solid().data(), first);
  other.shapes[1].shape = geometry::Box{{0.1, 0.1, 0.1}};
  EXPECT_NE(&other.solid().data(), first);
  EXPECT_EQ(&thing.solid().data(), first);  // still
}

TEST(Obstacle, RefusesTheLabelOfAnother) {
  const std::vector<PlacedShape> ball{{geometry::Sphere{0.1}, kAside}};
  const Obstacle padded{"a", ball, kAside, 0.01}, named{"a (padding 10 mm)", ball, kAside};
  for (const auto& both : {std::vector{padded, named}, std::vector{named, padded}})
    expect_refused([&] { require_obstacles(both); }, "'a (padding 10 mm)'");
}

TEST(Obstacle, RefusesABadPadding) {
  Obstacle thing{"thing", {{block(), kAside}}, Isometry3d::Identity()};
  for (const double padding : {-0.001, 0.6, std::nan("")}) {
    thing.padding = padding;
    EXPECT_NE(complaint([&] {
                require_obstacles({thing});
              }).find("obstacles[0].padding must be in [0, 0.5] m"),
              std::string::npos);
  }
  geometry::Mesh fine = block();
  fine.triangles = block().triangles.replicate(1, 417);
  thing.shapes = {{fine, kAside}};
  thing.padding = 0;
  require_obstacles({thing});
  thing.padding = 0.01;
  expect_refused([&] { require_obstacles({thing}); }, "at most 5000 triangles, not 5004");
}

}  // namespace
}  // namespace graspless::collision
