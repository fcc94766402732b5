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

/// What is left of a polygon when its contraction by `width` is taken away: the points near its
/// edges (Hang 2019, Section IV-B, P_g). The contraction is mitred: at a reflex corner the band is
/// a little wider.
class GRASPLESS_API Band {
 public:
  /// Throws std::invalid_argument unless `width` [m] is finite and positive.
  Band(const Polygon& polygon, double width);

  /// Whether `p` lies in the band.
  bool contains(const Eigen::Vector2d& p) const;

  /// A point of the band at least `margin` [m] inside the boundary, uniform by area where exact().
  /// Nothing when a thousand draws found none (a margin that leaves no room).
  std::optional<Eigen::Vector2d> sample(std::mt19937_64& rng, double margin = 0) const;

  /// The contracted polygon, in pieces; empty where nothing is left. From CGAL's straight skeleton,
  /// each piece verified to be simple and inside; `exact()` says whether that held.
  const std::vector<Polygon>& core() const { return core_; }
  /// False where CGAL's offset failed verification: sample() then draws (edge, place, depth) and
  /// keeps what lies in the polygon and within `width` of its boundary.
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
