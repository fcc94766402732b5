// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sampling/downsample.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "graspless/geometry/sampling.hpp"
#include "graspless/watch.hpp"

#include "geometry/require_points.hpp"
#include "geometry/sampling/point_grid.hpp"
#include "text.hpp"

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

/// The point nearest to the mean of each cell, ascending.
std::vector<int> one_of_each(const Eigen::Matrix3Xd& points, const PointGrid& grid) {
  std::vector<int> kept;
  for (int c = 0; c < grid.num_cells(); ++c) {
    poll();
    const int* members = grid.members().data();
    kept.push_back(nearest_to_mean(points, members + grid.first(c), members + grid.first(c + 1)));
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace

std::vector<int> downsample(const Eigen::Matrix3Xd& points, double cell) {
  require_points(points, "points");
  if (!(cell > 0 && cell <= kMaxLength)) {
    throw std::invalid_argument("cell must be in (0, " + figure(kMaxLength) + "] m, not " +
                                figure(cell));
  }
  return one_of_each(points, PointGrid(points, cell));
}

std::vector<int> downsample_to(const Eigen::Matrix3Xd& points, int count) {
  constexpr int kAttempts = 12;
  constexpr double kTolerance = 0.08;  // relative to `count`
  const Eigen::Vector3d sides = points.rowwise().maxCoeff() - points.rowwise().minCoeff();
  if (!(sides.norm() > 0)) return {0};  // all points are equal
  double cell = sides.norm() / std::sqrt(count);
  for (int i = 0; i < kAttempts; ++i) {
    const PointGrid grid(points, cell);
    const double factor = grid.num_cells() / static_cast<double>(count);
    if (std::abs(factor - 1) <= kTolerance) return one_of_each(points, grid);
    cell *=
        std::sqrt(factor);  // the number of cells on a surface falls with the square of their size
  }
  return downsample(points, cell);
}

}  // namespace graspless::geometry
