// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The triangle of a surface that is nearest to a point, by a tree of boxes.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "collision/clearance_triangles.hpp"
#include "once.hpp"

namespace graspless::collision {

/// A triangle, and the squared distance of a point from it [m^2].
struct NearTriangle {
  int triangle = -1;
  double squared = std::numeric_limits<double>::infinity();
};

/// A tree of boxes with four children each, built at the first query. Thread-safe.
class ClearanceTree {
 public:
  explicit ClearanceTree(std::vector<SurfaceTriangle> triangles);

  /// The distance to the surface; infinite if it is above `limit` [m].
  double distance(const Eigen::Vector3d& point, double limit) const;
  /// The triangle nearest to a point, or one whose squared distance is at most `enough` [m^2]. Any
  /// triangle may be the hint; the search is fast if it is near.
  NearTriangle nearest(const Eigen::Vector3d& point, int hint, double enough = 0) const;

 private:
  static constexpr int kChildren = 4;
  using Squares = Eigen::Array<double, kChildren, 1>;

  struct Node {
    Squares squared_distances(const Eigen::Vector3d& point) const;

    // Corners of the children's boxes, one in each row. Where there is no child, they are infinite.
    Eigen::Array<double, kChildren, 3> low, high;
    std::array<int, kChildren> children;  // index of a node, or ~index of a triangle
  };
  using Iterator = std::vector<int>::iterator;

  const Node& root() const;
  int add_node(Iterator begin, Iterator end) const;
  Iterator halve(Iterator begin, Iterator end) const;
  void search(const Node& node, const Eigen::Vector3d& point, double enough,
              NearTriangle& best) const;
  const SurfaceTriangle& triangle(int index) const { return triangles_[index]; }

  std::vector<SurfaceTriangle> triangles_;
  mutable Once built_;
  mutable std::vector<Node> nodes_;  // the root first
};

}  // namespace graspless::collision
