// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// CGAL's tree of boxes behind one door: the distance from a point to triangles.
#pragma once

#include <memory>

#include <Eigen/Core>

#include "graspless/geometry/shape.hpp"

namespace graspless::collision {

/// Immutable; the tree is built by whoever first asks. May be asked from several threads.
class ClearanceTree {
 public:
  explicit ClearanceTree(const geometry::Mesh& mesh);
  ~ClearanceTree();

  /// The distance to the surface [m]. `near` is any point of the surface, the nearer to `point` the
  /// faster the answer; it becomes the nearest.
  double distance(const Eigen::Vector3d& point, Eigen::Vector3d& near) const;
  /// As above, with the nearest of a few points of the surface to begin with.
  double distance(const Eigen::Vector3d& point) const;
  Eigen::Vector3d any_point() const { return hints_.col(0); }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  Eigen::Matrix3Xd hints_;
};

}  // namespace graspless::collision
