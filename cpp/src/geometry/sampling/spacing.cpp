// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Distances between nearest neighbours in a cloud.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "graspless/geometry/sampling.hpp"
#include "graspless/watch.hpp"

#include "geometry/quantile.hpp"
#include "geometry/require_points.hpp"
#include "geometry/sampling/point_grid.hpp"
#include "geometry/sampling/unevenness.hpp"

namespace graspless::geometry {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Removes duplicates, because many equal points would fill one cell whatever its size.
Eigen::Matrix3Xd distinct(const Eigen::Matrix3Xd& points) {
  std::vector<std::array<double, 3>> sorted;
  for (const auto& p : points.colwise()) sorted.push_back({p.x(), p.y(), p.z()});
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return Eigen::Map<const Eigen::Matrix3Xd>(sorted.data()->data(), 3,
                                            static_cast<Eigen::Index>(sorted.size()));
}

/// Ignores the point itself and points so close that the squared distance rounds to zero.
void keep_nearer(double squared, double& nearest) {
  if (squared > 0 && squared < nearest) nearest = squared;
}

/// Estimates the median squared distance from a few points, by comparing each with all others.
double guess(const Eigen::Matrix3Xd& points) {
  constexpr Eigen::Index kFew = 32;
  std::vector<double> nearest;
  const Eigen::Index step = std::max<Eigen::Index>(1, points.cols() / kFew);
  for (Eigen::Index i = 0; i < points.cols(); i += step) {
    poll();
    nearest.push_back(kInfinity);
    for (Eigen::Index j = 0; j < points.cols(); ++j) {
      keep_nearer((points.col(j) - points.col(i)).squaredNorm(), nearest.back());
    }
  }
  return median(nearest);
}

/// Computes squared distances to the nearest point; infinite if there is none in adjacent cells.
void find_nearest(const Eigen::Matrix3Xd& points, const PointGrid& grid,
                  std::vector<double>& nearest) {
  std::vector<int> around;
  for (int c = 0; c < grid.num_cells(); ++c) {
    poll();
    grid.points_around(c, around);
    for (int k = grid.first(c); k < grid.first(c + 1); ++k) {
      const int i = grid.members()[k];
      double& squared = nearest[i];
      squared = kInfinity;
      for (const int j : around) {
        keep_nearer((points.col(j) - points.col(i)).squaredNorm(), squared);
      }
    }
  }
}

/// Squared distances to the nearest neighbours, of which the least are exact: as many as the value
/// that `last` finds among them; none if no two points differ.
template <class Last>
std::vector<double> nearest_of(const Eigen::Matrix3Xd& cloud, const Last& last) {
  require_points(cloud, "points");
  if (cloud.cols() < 2) return {};
  const Eigen::Matrix3Xd points = distinct(cloud);
  const double first_guess = guess(points);
  if (!(first_guess < kInfinity)) return {};
  std::vector<double> nearest(points.cols());
  // A neighbour within a cell's side is certainly the nearest.
  for (double cell = 1.5 * std::sqrt(first_guess);; cell *= 2) {
    const PointGrid grid(points, cell);
    find_nearest(points, grid, nearest);
    if (std::sqrt(last(nearest)) <= grid.cell()) return nearest;
  }
}

}  // namespace

double spacing(const Eigen::Matrix3Xd& points) {
  std::vector<double> nearest = nearest_of(points, median<double>);
  return nearest.empty() ? 0 : std::sqrt(median(nearest));
}

double unevenness(const Eigen::Matrix3Xd& points) {
  const auto distance = [](const std::vector<double>& squares, double share) {
    return std::sqrt(quantile(squares, share));
  };
  const std::vector<double> nearest =
      nearest_of(points, [](const auto& squares) { return quantile(squares, 0.75); });
  if (nearest.empty()) return 0;
  return (distance(nearest, 0.75) - distance(nearest, 0.25)) / distance(nearest, 0.5);
}

}  // namespace graspless::geometry
