// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/geometry/polygon.hpp"

namespace graspless::geometry {

/// The points of a polygon near its edges: the polygon minus its contraction by `width` (P_g of
/// Hang 2019, Section IV-B). The contraction is mitred, so the band is a little wider at a reflex
/// corner.
class GRASPLESS_API Band {
 public:
  /// Throws std::invalid_argument unless `width` [m] lies in [kMinLength, kMaxLength].
  Band(const Polygon& polygon, double width);

  /// True if `p` lies in the band.
  bool contains(const Eigen::Vector2d& p) const;

  /// Random point of the band at least `margin` [m] inside the boundary, uniform by area if
  /// exact(). Empty after 1000 failed draws, as when the margin leaves no room.
  std::optional<Eigen::Vector2d> sample(std::mt19937_64& rng, double margin = 0) const;

  /// Pieces of the contracted polygon; empty if nothing is left. Computed by CGAL's straight
  /// skeleton. exact() is true if every piece was verified to be simple and inside the polygon.
  const std::vector<Polygon>& core() const { return core_; }
  /// False if CGAL's offset failed verification. sample() then draws an edge, a position along it
  /// and a depth, and rejects points outside the polygon or farther than `width` from its boundary.
  bool exact() const { return exact_; }

  const Polygon& polygon() const { return polygon_; }
  double width() const { return width_; }

 private:
  Eigen::Vector2d draw_inside(std::mt19937_64& rng) const;
  Eigen::Vector2d draw_near_edge(std::mt19937_64& rng) const;

  Polygon polygon_;
  double width_;
  bool exact_;
  std::vector<Polygon> core_;
  std::vector<Eigen::Matrix<double, 2, 3>> triangles_;  // of the whole polygon
  std::vector<double> cumulative_area_;                 // of triangles_
  std::vector<double> cumulative_length_;               // of the edges
};

}  // namespace graspless::geometry
