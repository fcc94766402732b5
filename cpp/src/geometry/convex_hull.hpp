// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {

/// The boundary of the convex hull: its corners only, triangles counter-clockwise from outside. The
/// points must span a volume (validate).
Mesh convex_hull(const Eigen::Matrix3Xd& points);

/// Whether a mesh is closed, oriented outward or inward throughout, and fills `hull`, its convex
/// hull.
bool is_convex(const Mesh& mesh, const Mesh& hull);

}  // namespace graspless::geometry
