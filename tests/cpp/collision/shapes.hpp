// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shapes and poses that the collision tests share.
#pragma once

#include <cmath>
#include <random>

#include "graspless/collision/world.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::collision {

inline Eigen::Isometry3d translation(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

inline double uniform(std::mt19937& rng, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(rng);
}

inline Eigen::Isometry3d random_pose(std::mt19937& rng, double reach) {
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond turn(normal(rng), normal(rng), normal(rng), normal(rng));
  const auto along = [&] { return uniform(rng, -reach, reach); };
  return Eigen::Translation3d(along(), along(), along()) * turn.normalized();
}

/// A closed upright prism with `sides` sides, triangles counter-clockwise from outside; its last
/// two vertices are the middles of the bases.
inline geometry::Mesh prism(int sides, double radius, double height) {
  geometry::Mesh mesh;
  mesh.vertices.resize(3, 2 * sides + 2);
  mesh.triangles.resize(3, 4 * sides);
  const int bottom = 2 * sides, top = bottom + 1;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    const Eigen::Vector2d corner(radius * std::cos(angle), radius * std::sin(angle));
    mesh.vertices.col(i) << corner, -height / 2;
    mesh.vertices.col(sides + i) << corner, height / 2;
    const int next = (i + 1) % sides;
    mesh.triangles.col(4 * i) << bottom, next, i;
    mesh.triangles.col(4 * i + 1) << top, sides + i, sides + next;
    mesh.triangles.col(4 * i + 2) << i, next, sides + next;
    mesh.triangles.col(4 * i + 3) << i, sides + next, sides + i;
  }
  mesh.vertices.col(bottom) << 0, 0, -height / 2;
  mesh.vertices.col(top) << 0, 0, height / 2;
  return mesh;
}

/// The same, its bases dented a little, so that it is not convex.
inline geometry::Mesh dented_prism(int sides, double radius, double height) {
  geometry::Mesh mesh = prism(sides, radius, height);
  mesh.vertices(2, 2 * sides) += 0.004 * height;
  mesh.vertices(2, 2 * sides + 1) -= 0.004 * height;
  return mesh;
}

/// Surface of a tube, open at both ends: a square of walls, each of `pieces` by `pieces` squares.
inline geometry::Mesh square_tube(int pieces, double side, double height) {
  geometry::Mesh mesh;
  const int around = 4 * pieces, rows = pieces + 1;
  mesh.vertices.resize(3, around * rows);
  mesh.triangles.resize(3, 2 * around * pieces);
  for (int i = 0; i < around; ++i) {
    const double angle = M_PI / 2 * (i / pieces), along = 1.0 * (i % pieces) / pieces - 0.5;
    const Eigen::Vector2d corner = Eigen::Rotation2Dd(angle) * Eigen::Vector2d(0.5, along) * side;
    for (int row = 0; row < rows; ++row) {
      mesh.vertices.col(row * around + i) << corner, height * (1.0 * row / pieces - 0.5);
    }
    for (int row = 0; row < pieces; ++row) {
      const int a = row * around + i, b = row * around + (i + 1) % around;
      mesh.triangles.col(2 * (row * around + i)) << a, b, b + around;
      mesh.triangles.col(2 * (row * around + i) + 1) << a, b + around, a + around;
    }
  }
  return mesh;
}

/// Body 0 is a, body 1 is b, and they are tested.
inline World two_bodies(const geometry::Shape& a, const geometry::Shape& b) {
  World world;
  world.add_body("a", {{a}});
  world.add_body("b", {{b}});
  world.add_pair(0, 1);
  return world;
}

}  // namespace graspless::collision
