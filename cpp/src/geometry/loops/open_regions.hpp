// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/ray_image.hpp"

namespace graspless::geometry {

/// Half spaces n^T p <= d, as rows (n, d).
using Planes = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// Half spaces of the convex hull of points, which must span a volume.
Planes hull_of(const Eigen::Matrix3Xd& points);

/// Labels the pixels whose rays pass the object by connected region; others get -1. Appends the
/// number of pixels of each region to `sizes`, and numbers the regions from its size before.
///
/// A ray passes if it is infinite, or ends behind the hull of the object: what ends inside, such as
/// on an apple in a bowl, may have the object behind it. Lines of single pixels and regions of few
/// are left out: at the edge of an object, a pixel may be a mixture of near and far.
Eigen::Array<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> open_regions(
    const RayImage& rays, const Planes& hull, std::vector<int>& sizes);

}  // namespace graspless::geometry
