// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

/// The sums over all pairs of segments behind linking.hpp. No function here allocates memory.
namespace graspless::geometry::kernels {

/// A polyline with one array per coordinate: segment j runs from corner j to corner j + 1.
struct Line {
  const double *x, *y, *z;
  int segments;
};

/// A polyline with interleaved coordinates. If it is closed, corner `segments` is the first again.
struct Curve {
  const Eigen::Matrix3Xd& corners;
  int segments;
};

/// Gauss linking integral of both curves, scaled by `scale`: a power of two that makes every
/// coordinate at most 1.
double gauss_integral(const Line& line, const Curve& curve, double scale);

/// Signed number of crossings of the closed line through the fan of triangles from `apex` (already
/// scaled) to the segments of the closed curve. Sets `is_certain` to false if a test was within
/// rounding of changing sides.
int signed_crossings(const Line& line, const Curve& curve, double scale,
                     const Eigen::Vector3d& apex, bool& is_certain);

}  // namespace graspless::geometry::kernels
