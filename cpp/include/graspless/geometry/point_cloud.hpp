// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/geometry/polygon.hpp"

namespace graspless::geometry {

/// Returns the points (2 x n) [m] of a square grid of `spacing` [m] inside a polygon. If the grid
/// misses the polygon, returns the polygon's first vertex. Throws std::invalid_argument unless
/// `spacing` is positive and gives at most 10^7 points.
GRASPLESS_API Eigen::Matrix2Xd sample_grid(const Polygon& polygon, double spacing);

/// Returns the outer boundary of planar points (2 x n) [m]: the tightest alpha shape (CGAL) that
/// contains every point and is one simple polygon, simplified by less than the point spacing. Holes
/// are filled. Throws std::invalid_argument that names `what` if there are fewer than three points,
/// if one is not finite, if all lie on a line, or if they form several pieces.
GRASPLESS_API Polygon outline(const Eigen::Matrix2Xd& points, const std::string& what = "points");

}  // namespace graspless::geometry
