// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/thinning.hpp"

#include <algorithm>
#include <cmath>

#include "graspless/geometry/sampling.hpp"

#include "geometry/point_grid.hpp"

namespace graspless::geometry {

std::vector<int> thinned_to(const Eigen::Matrix3Xd& points, int count) {
  constexpr int kAttempts = 12;
  constexpr double kNear = 0.08;  // of the count
  const Eigen::Vector3d sides = points.rowwise().maxCoeff() - points.rowwise().minCoeff();
  if (!(sides.norm() > 0)) return {0};  // all are equal
  double cell = sides.norm() / std::sqrt(count);
  for (int i = 0; i < kAttempts; ++i) {
    const double factor = PointGrid(points, cell).num_cells() / static_cast<double>(count);
    if (std::abs(factor - 1) <= kNear) break;
    cell *= std::sqrt(factor);  // as on a surface
  }
  return thin(points, cell);
}

}  // namespace graspless::geometry
