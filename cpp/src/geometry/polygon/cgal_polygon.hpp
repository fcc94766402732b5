// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

/// CGAL's 2-D algorithms with plain matrices of vertices (2 x n) [m] as interface. Each heavy
/// header of CGAL is compiled once.
namespace graspless::geometry {

/// True if the boundary does not cross or touch itself.
bool is_simple(const Eigen::Matrix2Xd& vertices);

/// Splits a simple counter-clockwise polygon into convex pieces.
std::vector<Eigen::Matrix2Xd> convex_partition(const Eigen::Matrix2Xd& vertices);

/// Contracts a polygon by `width` [m], mitred at reflex corners. Empty if nothing is left. The
/// offset of CGAL 5.5 can be wrong (its issue 7149), so the caller must verify the pieces. Passes
/// on the exceptions of CGAL.
std::vector<Eigen::Matrix2Xd> contract(const Eigen::Matrix2Xd& vertices, double width);

}  // namespace graspless::geometry
