// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

/// The sums over all pairs of segments behind linking.hpp. Nothing here allocates.
namespace graspless::geometry::kernels {

/// A polyline by coordinates: segment j runs from corner j to corner j + 1.
struct Line {
  const double *x, *y, *z;
  int segments;
};

/// The corners of a curve, three numbers each; corner `segments` is the first again where it is
/// closed.
struct Curve {
  const Eigen::Matrix3Xd& corners;
  int segments;
  Eigen::Vector3d corner(int i) const { return corners.col(i < corners.cols() ? i : 0); }
};

/// Both times `scale` (a power of two that makes every coordinate at most 1): the Gauss integral.
double gauss_integral(const Line& line, const Curve& curve, double scale);

/// How often the closed line runs through the fan from `apex` (scaled) over the closed curve, with
/// signs. `is_sure` becomes false where a test was within rounding of changing sides.
int signed_crossings(const Line& line, const Curve& curve, double scale,
                     const Eigen::Vector3d& apex, bool& is_sure);

}  // namespace graspless::geometry::kernels
