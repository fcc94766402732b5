// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/shape.hpp"

#include "once.hpp"

namespace graspless::collision {

/// The volume that a triangle surface bounds, if the surface is closed: every edge belongs to an
/// even number of triangles. Vertices at the same place count as one. Prepared at the first query.
/// Thread-safe.
class Enclosure {
 public:
  explicit Enclosure(geometry::Mesh mesh) : mesh_(std::move(mesh)) {}

  /// True if the surface is closed and `p` lies inside: a ray from it passes through the surface an
  /// odd number of times. Either result is possible on the surface itself.
  bool contains(const Eigen::Vector3d& p) const;
  /// One vertex of each connected part of the surface, or of its first 64, 3 x n.
  const Eigen::Matrix3Xd& vertex_of_each_part() const;

 private:
  void prepare() const;
  void weld() const;
  void find_parts() const;
  bool is_closed() const;
  void fill_grid(const Eigen::Matrix2Xd& flat) const;
  Eigen::Vector2i cell(const Eigen::Vector2d& p) const;
  bool covers(Eigen::Index triangle, const Eigen::Vector2d& p) const;
  bool lies_below(Eigen::Index triangle, const Eigen::Vector3d& p) const;

  mutable Once once_;
  mutable Eigen::Matrix3Xd parts_;
  mutable geometry::Mesh mesh_;  // turned so that the ray points along z; empty unless closed
  mutable Eigen::Vector2d corner_, scale_;  // of the grid: its lower corner [m] and cells per metre
  mutable Eigen::Vector2i num_cells_;
  mutable std::vector<std::vector<int>> cells_;  // triangles above each cell of the x-y plane
};

}  // namespace graspless::collision
