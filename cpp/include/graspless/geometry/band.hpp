// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/geometry/polygon.hpp"

namespace graspless::geometry {

/// The points of a polygon that lie within `width` of its boundary: what is left when the polygon is
/// contracted by `width` (Hang 2019, Section IV-B, P_g).
class GRASPLESS_API Band {
 public:
  /// Throws std::invalid_argument unless `width` [m] is finite and positive.
  Band(const Polygon& polygon, double width);

  /// A point drawn uniformly by area, at least `margin` [m] inside the boundary.
  Eigen::Vector2d sample(std::mt19937_64& rng, double margin = 0) const;

  /// The contracted polygon, in pieces; empty where nothing is left. From CGAL's straight skeleton, each
  /// piece verified to be simple and inside; `exact()` says whether that held.
  const std::vector<Polygon>& core() const { return core_; }
  /// False where CGAL's offset failed verification: sample() then draws (edge, place, depth) and keeps what
  /// lies in the polygon and within `width` of its boundary.
  bool exact() const { return exact_; }

  const Polygon& polygon() const { return polygon_; }
  double width() const { return width_; }

 private:
  Polygon polygon_;
  double width_;
  bool exact_;
  std::vector<Polygon> core_;
  std::vector<Eigen::Matrix<double, 2, 3>> triangles_;  // of the band, where exact
  std::vector<double> cumulative_area_;
};

}  // namespace graspless::geometry
