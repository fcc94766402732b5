// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace graspless::geometry {

/// Interquartile range of the distances between nearest neighbours among the points (3 x n),
/// relative to their median: 0.1 where points keep a distance from each other, 0.35 if these have
/// noise of a quarter of their spacing, 0.57 to 0.8 for independent random points of a surface. 0
/// if no two points differ.
double unevenness(const Eigen::Matrix3Xd& points);

}  // namespace graspless::geometry
