// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/geometry/polygon.hpp"

namespace graspless::geometry {

/// Points on a square grid of `spacing` [m] inside a polygon (2 x n); never empty: the first vertex
/// stands where the grid misses the polygon. Throws std::invalid_argument where there would be more
/// than ten million.
GRASPLESS_API Eigen::Matrix2Xd sample_grid(const Polygon& polygon, double spacing);

/// The outer boundary of planar points (2 x n): the tightest alpha shape (CGAL) that holds every
/// point and is one simple piece, simplified by less than the points' spacing. Holes are filled.
/// Throws std::invalid_argument, naming `what`, when the points are fewer than three, not finite,
/// or on a line.
GRASPLESS_API Polygon outline(const Eigen::Matrix2Xd& points, const std::string& what = "points");

}  // namespace graspless::geometry
