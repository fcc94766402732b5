// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::mechanics {

/// Indices of the points (2 x n) that are corners of their convex hull, ascending. A point within
/// `tolerance` of the hull of the others is no corner. That leaves out points inside, points on an
/// edge, and all but one of a cluster.
std::vector<int> patch_corners(const Eigen::Matrix2Xd& points, double tolerance);

}  // namespace graspless::mechanics
