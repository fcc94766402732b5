// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::mechanics {

/// Which of these points (2 x n) are corners of their convex hull, ascending. A point within
/// `tolerance` of the hull of the rest is none: points inside, within an edge, and all but one of a
/// cluster.
std::vector<int> patch_corners(const Eigen::Matrix2Xd& points, double tolerance);

}  // namespace graspless::mechanics
