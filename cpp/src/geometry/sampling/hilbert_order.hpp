// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::geometry {

/// Sorts points (3 x n) along a Hilbert curve (CGAL), so that neighbours in space are close in
/// memory.
Eigen::Matrix3Xd in_hilbert_order(const Eigen::Matrix3Xd& points);

/// Indices of points (3 x n) along a Z-shaped curve (Morton 1966), which neighbours in space are
/// nearly as close on, and which is quicker. Equal points keep their order.
std::vector<int> morton_order(const Eigen::Matrix3Xd& points);

}  // namespace graspless::geometry
