// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Trees of convex hulls around a shape.
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/geometry/shape.hpp"

#include "collision/bounds.hpp"

namespace graspless::collision {

/// Convex body that encloses a part of a shape: the hull of some vertices, or their box.
struct Hull {
  Eigen::Vector3d middle, half;  ///< box around the part, in the core's frame [m]
  int first = 0, count = 0;      ///< vertices in HullTree::coordinates; none: the box is meant
  int child = -1;                ///< the first of two parts; -1 in a leaf
  int begin = 0, end = 0;        ///< of its triangles in HullTree::order, in a leaf of a surface
};

/// Tree of convex hulls around a shape, in its core's frame. Its root is hulls[0].
struct HullTree {
  std::vector<Hull> hulls;
  std::vector<double> coordinates;  ///< of each hull, its vertices' x, then y, then z [m]; the last
                                    ///< vertex repeats up to a multiple of four
  double radius = 0;                ///< the shape lies within this distance of each hull [m]
  bool is_of_mesh = false;          ///< boxes bound other shapes about as well, and faster
  std::shared_ptr<const geometry::Mesh> surface;  ///< in the core's frame; none for other shapes
  std::vector<int> order;                         ///< its triangles, leaf by leaf

  bool has_parts() const { return hulls[0].child >= 0; }
  /// The point of a hull that lies farthest along a direction.
  Eigen::Vector3d farthest(const Hull& hull, const Eigen::Vector3d& direction) const;
  /// The corner of a triangle of the surface that lies farthest along a direction.
  Eigen::Vector3d farthest_corner(int triangle, const Eigen::Vector3d& direction) const;
};

/// Returns the tree of a single box.
HullTree box_tree(const Core& core);
/// Returns the tree of a single convex hull.
HullTree convex_tree(const Eigen::Matrix3Xd& vertices);
/// Returns the tree of a surface: parts of neighbouring triangles, below the hull of all.
HullTree surface_tree(std::shared_ptr<const geometry::Mesh> surface, const Eigen::Matrix3Xd& hull);

}  // namespace graspless::collision
