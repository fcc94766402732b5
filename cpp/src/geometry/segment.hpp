// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Nearest points of segments.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace graspless::geometry {

/// Place on the segment from a to b that is nearest to p: 0 at a, 1 at b, and 0 if both are one
/// point.
template <typename P, typename A, typename B>
double nearest_on_segment(const P& p, const A& a, const B& b) {
  const auto along = (b - a).eval();
  const double square = along.squaredNorm();
  return square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
}

/// Distance of p from the segment from a to b.
template <typename P, typename A, typename B>
double distance_to_segment(const P& p, const A& a, const B& b) {
  return (p - a - nearest_on_segment(p, a, b) * (b - a)).norm();
}

/// Distance of p from a closed polyline, 3 x n [m].
inline double distance_to_loop(const Eigen::Matrix3Xd& loop, const Eigen::Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < loop.cols(); ++i) {
    const Eigen::Vector3d a = loop.col(i), b = loop.col((i + 1) % loop.cols());
    least = std::min(least, (p - a - nearest_on_segment(p, a, b) * (b - a)).squaredNorm());
  }
  return std::sqrt(least);
}

}  // namespace graspless::geometry
