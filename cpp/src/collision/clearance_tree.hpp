// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Wraps CGAL's AABB tree: the distance from a point to triangles.
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "collision/clearance_triangles.hpp"

namespace graspless::collision {

/// An AABB tree, built at the first query. Thread-safe.
class ClearanceTree {
 public:
  explicit ClearanceTree(const std::vector<SurfaceTriangle>& triangles);
  ~ClearanceTree();

  /// The distance to the surface; infinite if it is above `limit` [m].
  double distance(const Eigen::Vector3d& point, double limit) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  Eigen::Matrix3Xd hints_;  // points of the surface; a search begins at the nearest
};

}  // namespace graspless::collision
