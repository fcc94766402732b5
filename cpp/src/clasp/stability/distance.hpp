// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Core>

#include "graspless/geometry/shape.hpp"

namespace graspless::clasp {

/// Function of a point in the frame of a link [m].
using Distance = std::function<double(const Eigen::Vector3d& p_L)>;

/// Distance of a point outside a shape. Meshes are surfaces.
Distance distance_to(const geometry::PlacedShape& placed);

/// Unit gradient by finite differences; zero where there is none.
Eigen::Vector3d gradient(const Distance& distance, const Eigen::Vector3d& p_L);

/// Calls visit(p) for points on a triangle, at most `spacing` apart [m].
template <typename Visit>
void visit_points(const Eigen::Matrix3d& corners, double spacing, Visit visit) {
  const Eigen::Vector3d a = corners.col(0), u = corners.col(1) - a, v = corners.col(2) - a;
  const double longest = std::max({u.norm(), v.norm(), (u - v).norm()});
  const int n = std::clamp(static_cast<int>(std::ceil(longest / spacing)), 1, 60);
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; i + k <= n; ++k) visit(Eigen::Vector3d(a + (i * u + k * v) / n));
  }
}

}  // namespace graspless::clasp
