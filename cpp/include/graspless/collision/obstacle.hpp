// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/solid.hpp"
#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::collision {

/// A fixed body that a motion must avoid.
struct GRASPLESS_API Obstacle {
  std::string name;
  std::vector<geometry::PlacedShape> shapes;  ///< in its frame B
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  double padding = 0;  ///< distance that motions keep from the shapes [m]

  /// The body that motions must not touch: the shapes, grown by the padding, and a name for
  /// messages, which states the padding. The solids of the last padded meshes are kept.
  std::vector<geometry::PlacedShape> grown() const;
  Solid solid() const;
  std::string label() const;
};

/// Throws std::invalid_argument that begins with `field` if the padding is not in
/// [0, geometry::kMaxPadding], or if the meshes of an obstacle with a padding have more than
/// geometry::kMaxPaddedTriangles triangles together.
GRASPLESS_API void require_padding(const Obstacle& obstacle, const std::string& field);

/// Throws std::invalid_argument that names the obstacle and the field if a name is in `taken`
/// (`takers` describes by whom) or occurs twice, if an obstacle has no shape, an invalid one or an
/// invalid padding, or if a pose is not rigid.
GRASPLESS_API void require_obstacles(const std::vector<Obstacle>& obstacles,
                                     std::set<std::string> taken = {},
                                     const std::string& takers = "another obstacle");

}  // namespace graspless::collision
