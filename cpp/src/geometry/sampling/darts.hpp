// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::geometry {

/// Points in the order of coarse cells, so that neighbours are near each other in memory.
Eigen::Matrix3Xd in_cell_order(const Eigen::Matrix3Xd& points);

/// Selects `count` points that are spread evenly, in a fraction of the time of eliminate_samples():
/// keeps every point that is not too near to one kept before, and drops what is too many. `points`:
/// 3 x n [m], n at least 5 * count, spread over a surface of `area` [m^2], best in_cell_order().
/// Returns the indices kept, ascending.
std::vector<int> throw_darts(const Eigen::Matrix3Xd& points, int count, double area);

}  // namespace graspless::geometry
