// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sampling and filtering of point clouds: surfaces of known bodies, views of a camera,
// downsampling.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {

/// Returns `count` points (3 x count) [m] spread evenly over the outer surface of the union of
/// shapes (Yuksel 2015; more than 100,000 by Poisson disc sampling, a little less evenly). Points
/// inside another shape are omitted. A mesh has no inside. The same seed gives the same points.
/// Throws std::invalid_argument unless `count` is in [1, 10^7] and every shape is valid.
GRASPLESS_API Eigen::Matrix3Xd sample_surface(const std::vector<PlacedShape>& shapes, int count,
                                              std::uint64_t seed = 1);

/// Returns the indices of the points (3 x n) [m] visible from `viewpoint` [m], ascending (hidden
/// point removal; Katz, Tal, Basri 2007). Throws std::invalid_argument unless every point is finite
/// and differs from the viewpoint.
GRASPLESS_API std::vector<int> visible_points(const Eigen::Matrix3Xd& points,
                                              const Eigen::Vector3d& viewpoint);

/// Returns the median distance between nearest neighbours among the points (3 x n) [m]. Equal
/// points count once. 0 if no two points differ. Throws std::invalid_argument unless every point is
/// finite.
GRASPLESS_API double spacing(const Eigen::Matrix3Xd& points);

/// Downsamples a cloud (3 x n) [m] to one point per cubic cell of side `cell` [m]: the point
/// nearest to the mean of the cell's points. Returns the indices kept, ascending. Throws
/// std::invalid_argument unless `cell` is in (0, 10000] and every point is finite.
GRASPLESS_API std::vector<int> downsample(const Eigen::Matrix3Xd& points, double cell);

}  // namespace graspless::geometry
