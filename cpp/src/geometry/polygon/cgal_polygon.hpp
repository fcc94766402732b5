// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

/// CGAL's 2-D algorithms on plain matrices of vertices (2 x n), so that its headers are compiled
/// once each.
namespace graspless::geometry {

bool is_simple(const Eigen::Matrix2Xd& vertices);

/// Of a simple counter-clockwise polygon.
std::vector<Eigen::Matrix2Xd> convex_partition(const Eigen::Matrix2Xd& vertices);

/// The polygon contracted by `width`, mitred at reflex corners; empty when nothing is left. As CGAL
/// gives it: its 5.5 offset can be wrong (issue 7149), the caller verifies. Throws what CGAL
/// throws.
std::vector<Eigen::Matrix2Xd> contract(const Eigen::Matrix2Xd& vertices, double width);

}  // namespace graspless::geometry
