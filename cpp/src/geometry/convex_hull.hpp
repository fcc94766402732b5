// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {

/// True if the smallest extent of the points in any direction is not negligible against the
/// largest.
bool spans_volume(const Eigen::Matrix3Xd& points);

/// Boundary of the convex hull of points (3 x n) [m]: its corners, and triangles that are
/// counter-clockwise seen from outside. The points must span a volume.
Mesh convex_hull(const Eigen::Matrix3Xd& points);

/// Half spaces n . p <= d of a convex hull, as columns (n, d).
Eigen::Matrix4Xd half_spaces(const Mesh& hull);

/// Corners of the convex hull of points (2 x n) [m], counter-clockwise.
Eigen::Matrix2Xd convex_outline(const Eigen::Matrix2Xd& points);

/// True if a mesh is closed, consistently oriented, and fills `hull`, its convex hull.
bool is_convex(const Mesh& mesh, const Mesh& hull);

}  // namespace graspless::geometry
