// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// A cloud with one point a cell.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "graspless/geometry/sampling.hpp"

#include "geometry/point_grid.hpp"
#include "geometry/require_points.hpp"

namespace graspless::geometry {
namespace {

int nearest_to_mean(const Eigen::Matrix3Xd& points, const int* begin, const int* end) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const int* i = begin; i != end; ++i) mean += points.col(*i);
  mean /= static_cast<double>(end - begin);
  return *std::min_element(begin, end, [&](int a, int b) {
    return (points.col(a) - mean).squaredNorm() < (points.col(b) - mean).squaredNorm();
  });
}

}  // namespace

std::vector<int> thin(const Eigen::Matrix3Xd& points, double cell) {
  require_points(points, "points");
  if (!(cell > 0 && cell <= kMaxLength)) {
    throw std::invalid_argument("cell must be in (0, " + std::to_string(kMaxLength) + "] m, not " +
                                std::to_string(cell));
  }
  const PointGrid grid(points, cell);
  std::vector<int> kept;
  for (int c = 0; c < grid.num_cells(); ++c) {
    const int* members = grid.members().data();
    kept.push_back(nearest_to_mean(points, members + grid.first(c), members + grid.first(c + 1)));
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace graspless::geometry
