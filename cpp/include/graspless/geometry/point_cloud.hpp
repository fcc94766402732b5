// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/geometry/polygon.hpp"

namespace graspless::geometry {

/// Points on a square grid of `spacing` [m] inside a polygon (2 x n); never empty: the centroid's nearest
/// inside point is taken where no grid point falls inside.
GRASPLESS_API Eigen::Matrix2Xd sample_grid(const Polygon& polygon, double spacing);

/// The median distance of a point to its nearest neighbour [m]. `points` is 2 x n, n >= 2.
GRASPLESS_API double median_spacing(const Eigen::Matrix2Xd& points);

/// The outer boundary of planar points (2 x n): the smallest alpha shape that is one piece and holds every
/// point but stray ones. Holes are filled. Throws std::invalid_argument when the points span no area.
GRASPLESS_API Polygon outline(const Eigen::Matrix2Xd& points);

}  // namespace graspless::geometry
