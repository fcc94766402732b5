// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/solid.hpp"
#include "graspless/export.hpp"
#include "graspless/geometry/band.hpp"
#include "graspless/geometry/polygon.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::slide {

/// A flat surface to slide on: a polygon in the plane z = 0 of its frame S (z up, out of the
/// surface).
class GRASPLESS_API Support {
 public:
  /// `slab`: thickness of the table top [m]. `band_width`: width of P_g, the band along the edges
  /// where slides may end [m]. `friction`: coefficient of friction between object and support.
  /// `usable_edges`: indices of the edges over which objects may stick out; by default all. Beyond
  /// the others nobody knows what there is. Throws std::invalid_argument unless lengths and
  /// friction are positive, X_WS is a rigid pose tilted by at most 60 degrees, and the indices are
  /// those of at least one edge, each once.
  Support(const geometry::Polygon& polygon, const Eigen::Isometry3d& X_WS, double slab = 0.04,
          double band_width = 0.06, double friction = 0.3,
          const std::optional<std::vector<int>>& usable_edges = std::nullopt);

  /// Q and P_g of the paper, in S.
  const geometry::Polygon& polygon() const { return goal_band_.polygon(); }
  const geometry::Band& goal_band() const { return goal_band_; }
  const Eigen::Isometry3d& X_WS() const { return X_WS_; }
  double slab() const { return slab_; }
  double friction() const { return friction_; }
  /// True if objects may stick out over an edge of the polygon. Throws std::invalid_argument if
  /// there is no such edge.
  bool is_usable(int edge) const;
  bool has_unusable_edges() const;
  Eigen::Vector3d normal_W() const { return X_WS_.linear().col(2); }
  /// Prisms over the convex parts of the polygon, below z = 0, in S.
  const std::vector<geometry::PlacedShape>& shapes() const { return shapes_; }
  const collision::Solid& solid() const { return solid_; }

 private:
  geometry::Band goal_band_;
  Eigen::Isometry3d X_WS_;
  double slab_, friction_;
  std::vector<bool> is_usable_;  // one per edge
  std::vector<geometry::PlacedShape> shapes_;
  collision::Solid solid_;
};

}  // namespace graspless::slide
