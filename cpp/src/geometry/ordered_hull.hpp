// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {

/// A convex hull as it would be whatever the order of its points and of memory: corners and
/// triangles sorted, every flat facet cut into a fan about its first corner. CGAL's depends on
/// where its facets happen to lie.
Mesh ordered(const Mesh& hull);

}  // namespace graspless::geometry
