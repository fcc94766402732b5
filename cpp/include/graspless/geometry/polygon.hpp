// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"

namespace graspless::geometry {

/// A simple polygon in the plane with counter-clockwise vertices, convex or not.
class GRASPLESS_API Polygon {
 public:
  /// An edge from vertex `index` to the next.
  struct Edge {
    int index;
    Eigen::Vector2d a, b;    ///< end points [m]
    Eigen::Vector2d inward;  ///< unit normal pointing inside
  };

  /// `vertices`: 2 x n [m]; a clockwise list is reversed. Throws std::invalid_argument that names
  /// `what` on fewer than three vertices, a coordinate beyond kMaxLength, a repeated vertex, or a
  /// boundary that crosses or touches itself.
  explicit Polygon(const Eigen::Matrix2Xd& vertices, const std::string& what = "polygon");

  const Eigen::Matrix2Xd& vertices() const { return vertices_; }
  int size() const { return static_cast<int>(vertices_.cols()); }
  double area() const;               ///< [m^2], positive
  Eigen::Vector2d centroid() const;  ///< centroid of the area [m]
  bool is_convex() const;

  /// True if `p` [m] lies inside. A point on the boundary may count either way.
  bool contains(const Eigen::Vector2d& p) const;
  /// Distance from `p` to the boundary [m], positive inside and negative outside.
  double depth(const Eigen::Vector2d& p) const;
  /// True if contains(p), and `p` lies at least `margin` >= 0 from the boundary [m]. Takes less
  /// time than depth().
  bool has_margin(const Eigen::Vector2d& p, double margin) const;
  /// Edge from vertex `index` to the next. Throws std::invalid_argument for another index.
  Edge edge(int index) const;
  /// Edge nearest to `p` [m]. If two are equally near, as at a corner, the one whose line `p` lies
  /// farther outside of.
  Edge nearest_edge(const Eigen::Vector2d& p) const;

  /// Convex polygons that cover this one without overlap (CGAL).
  std::vector<Polygon> convex_parts() const;

 private:
  Eigen::Matrix2Xd vertices_;
  Eigen::Vector2d lower_, upper_;  // bounding box: most queries end here
};

}  // namespace graspless::geometry
