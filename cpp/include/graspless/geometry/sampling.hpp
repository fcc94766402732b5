// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

/// Point clouds of known bodies, as a camera would see them.
namespace graspless::geometry {

/// `count` points (3 x count) spread evenly over the outer surface of the shapes' union: points
/// inside another shape are left out. A mesh counts as its surface. The same seed gives the same
/// points. Throws std::invalid_argument unless count is in [1, 10^7] and every shape is valid.
GRASPLESS_API Eigen::Matrix3Xd sample_surface(const std::vector<PlacedShape>& shapes, int count,
                                              std::uint64_t seed = 1);

/// Columns of the points that are seen from `viewpoint` (hidden point removal; Katz, Tal, Basri
/// 2007), ascending. Throws std::invalid_argument unless every point is finite and none is the
/// viewpoint.
GRASPLESS_API std::vector<int> visible_points(const Eigen::Matrix3Xd& points,
                                              const Eigen::Vector3d& viewpoint);

/// The median distance from a point to its nearest other point [m]; equal points count once. 0
/// where no two points differ. Throws std::invalid_argument unless every point is finite.
GRASPLESS_API double spacing(const Eigen::Matrix3Xd& points);

/// One point a cubic cell of side `cell` [m]: the one nearest to the mean of the cell's points.
/// Columns kept, ascending. Throws std::invalid_argument unless the cell is positive and every
/// point finite.
GRASPLESS_API std::vector<int> downsample(const Eigen::Matrix3Xd& points, double cell);

}  // namespace graspless::geometry
