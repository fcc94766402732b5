// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sampling/sample_elimination.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

#include "graspless/watch.hpp"

#include "geometry/sampling/point_grid.hpp"

namespace graspless::geometry {
namespace {

/// Neighbours of every point, with the weight by which they crowd it.
struct Neighbours {
  struct Entry {
    int point;
    float weight;
  };
  std::vector<std::size_t> begin, end;  // range of each point in `entries`
  std::vector<Entry> entries;
};

float weight(double distance, double reach) {
  const double w = 1 - distance / reach;
  const double squared = w * w, fourth = squared * squared;
  return static_cast<float>(fourth * fourth);
}

Neighbours find_neighbours(const Eigen::Matrix3Xd& points, double reach) {
  const PointGrid grid(points, reach);
  Neighbours all;
  all.begin.resize(points.cols());
  all.end.resize(all.begin.size());
  std::vector<int> around;
  for (int c = 0; c < grid.num_cells(); ++c) {
    poll();
    grid.points_around(c, around);
    for (int k = grid.first(c); k < grid.first(c + 1); ++k) {
      const int i = grid.members()[k];
      all.begin[i] = all.entries.size();
      for (const int j : around) {
        const double squared = (points.col(j) - points.col(i)).squaredNorm();
        if (j == i || squared >= reach * reach) continue;
        all.entries.push_back({j, weight(std::sqrt(squared), reach)});
      }
      all.end[i] = all.entries.size();
    }
  }
  return all;
}

/// A queue of points, most crowded first. Crowding only decreases, so an outdated entry is put back
/// with its current value.
class CrowdingQueue {
 public:
  explicit CrowdingQueue(const Neighbours& neighbours)
      : neighbours_(neighbours), crowding_(neighbours.begin.size(), 0) {
    std::vector<std::pair<float, int>> entries;
    for (std::size_t i = 0; i < crowding_.size(); ++i) {
      poll();
      for (std::size_t k = neighbours.begin[i]; k < neighbours.end[i]; ++k) {
        crowding_[i] += neighbours.entries[k].weight;
      }
      entries.emplace_back(crowding_[i], static_cast<int>(i));
    }
    queue_ = std::priority_queue<std::pair<float, int>>({}, std::move(entries));
  }

  std::size_t pop_most_crowded() {
    auto [value, point] = queue_.top();
    for (queue_.pop(); value > crowding_[point]; queue_.pop()) {
      queue_.emplace(crowding_[point], point);
      std::tie(value, point) = queue_.top();
    }
    const std::size_t i = static_cast<std::size_t>(point);
    for (std::size_t k = neighbours_.begin[i]; k < neighbours_.end[i]; ++k) {
      const Neighbours::Entry& entry = neighbours_.entries[k];
      crowding_[entry.point] -= entry.weight;
    }
    return i;
  }

 private:
  const Neighbours& neighbours_;
  std::vector<float> crowding_;
  std::priority_queue<std::pair<float, int>> queue_;
};

}  // namespace

std::vector<int> eliminate_samples(const Eigen::Matrix3Xd& points, int count, double area) {
  // Largest radius at which `count` discs fit on the area (hexagonal packing).
  const double radius = std::sqrt(area / (2 * std::sqrt(3.0) * count));
  const Neighbours neighbours = find_neighbours(points, 2 * radius);
  CrowdingQueue queue(neighbours);
  const std::size_t n = static_cast<std::size_t>(points.cols());
  std::vector<bool> is_out(n, false);
  for (std::size_t left = n; left > static_cast<std::size_t>(count); --left) {
    poll();
    is_out[queue.pop_most_crowded()] = true;
  }
  std::vector<int> kept;
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_out[i]) kept.push_back(static_cast<int>(i));
  }
  return kept;
}

}  // namespace graspless::geometry
