// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sample_elimination.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "geometry/point_grid.hpp"

namespace graspless::geometry {
namespace {

/// What points within reach of each other add to each other's crowding.
struct Neighbours {
  std::vector<std::size_t> first;  // of a point, in the lists; one more at the end
  std::vector<int> points;
  std::vector<float> weights;
};

float weight(double distance, double reach) {
  const double w = 1 - distance / reach;
  const double squared = w * w, fourth = squared * squared;
  return static_cast<float>(fourth * fourth);
}

Neighbours find_neighbours(const Eigen::Matrix3Xd& points, double reach) {
  const PointGrid grid(points, reach);
  Neighbours all;
  for (int i = 0; i < static_cast<int>(points.cols()); ++i) {
    all.first.push_back(all.points.size());
    grid.near(i, [&](int j) {
      const double squared = (points.col(j) - points.col(i)).squaredNorm();
      if (j == i || squared >= reach * reach) return;
      all.points.push_back(j);
      all.weights.push_back(weight(std::sqrt(squared), reach));
    });
  }
  all.first.push_back(all.points.size());
  return all;
}

}  // namespace

std::vector<int> eliminate_samples(const Eigen::Matrix3Xd& points, int count, double area) {
  // No `count` discs of this radius fit on the area.
  const double radius = std::sqrt(area / (2 * std::sqrt(3.0) * count));
  const Neighbours neighbours = find_neighbours(points, 2 * radius);
  const std::size_t n = static_cast<std::size_t>(points.cols());

  std::vector<double> crowding(n, 0);
  std::vector<std::pair<double, int>> entries;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = neighbours.first[i]; k < neighbours.first[i + 1]; ++k) {
      crowding[i] += static_cast<double>(neighbours.weights[k]);
    }
    entries.emplace_back(crowding[i], static_cast<int>(i));
  }
  // Crowding only falls: an entry that is out of date goes back with what is true now.
  std::priority_queue<std::pair<double, int>> queue({}, std::move(entries));
  std::vector<bool> is_out(n, false);
  for (std::size_t left = n; left > static_cast<std::size_t>(count);) {
    const auto [value, point] = queue.top();
    const std::size_t i = static_cast<std::size_t>(point);
    queue.pop();
    if (value > crowding[i]) {
      queue.emplace(crowding[i], point);
      continue;
    }
    is_out[i] = true;
    --left;
    for (std::size_t k = neighbours.first[i]; k < neighbours.first[i + 1]; ++k) {
      crowding[static_cast<std::size_t>(neighbours.points[k])] -=
          static_cast<double>(neighbours.weights[k]);
    }
  }
  std::vector<int> kept;
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_out[i]) kept.push_back(static_cast<int>(i));
  }
  return kept;
}

}  // namespace graspless::geometry
