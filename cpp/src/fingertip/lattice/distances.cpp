// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Backward search for one sphere, guided by its straight distance to where it starts.
#include "fingertip/lattice/distances.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::fingertip {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSamePlace = 1e-12;  // [m]

std::size_t ix(int i) { return static_cast<std::size_t>(i); }

}  // namespace

LatticeDistances::LatticeDistances(LatticeSpace& space, const Locations& locations)
    : space_(space), tables_(ix(locations.size())) {
  // On the floor only where a sphere is in plan matters.
  const auto in_plan = [&](int location) -> Eigen::Vector2d {
    return space.center_W(space.start(), location).head<2>();
  };
  for (int l = 0; l < locations.size(); ++l) {
    int same = 0;
    while (same < l && (in_plan(same) - in_plan(l)).norm() > kSamePlace) ++same;
    table_of_.push_back(same);
  }
}

const double* LatticeDistances::to_goal(int location, double limit) {
  const int table = table_of_[ix(location)];
  if (tables_[ix(table)].empty()) tables_[ix(table)] = search(table, limit);
  return tables_[ix(table)].data();
}

std::vector<double> LatticeDistances::search(int location, double limit) {
  const Eigen::Vector3d start_W = space_.center_W(space_.start(), location);
  std::vector<double> arcs;  // yaws x moves
  for (int yaw = 0; yaw < space_.num_yaws(); ++yaw) {
    for (int move = 0; move < LatticeSpace::kMoves; ++move) {
      arcs.push_back(space_.displacement(yaw, move, location));
    }
  }
  std::vector<double> distances(ix(space_.num_poses()), kInfinity);
  const auto push = [&](int pose, double distance) {
    if (distance >= distances[ix(pose)]) return;
    const double left = (space_.center_W(pose, location) - start_W).norm() * (1 - 1e-12);
    if (distance + left >= limit) return;
    distances[ix(pose)] = distance;
    heap_.push_back({distance, pose});
    std::push_heap(heap_.begin(), heap_.end());
  };
  heap_.clear();
  push(space_.goal(), 0);
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end());
    const Entry entry = heap_.back();
    heap_.pop_back();
    if (entry.distance > distances[ix(entry.pose)] || !space_.is_free(entry.pose)) continue;
    for (int move = 0; move < LatticeSpace::kMoves; ++move) {
      const int from = space_.next(entry.pose, LatticeSpace::reverse(move));
      if (from < 0) continue;
      push(from, entry.distance + arcs[ix(space_.yaw(from) * LatticeSpace::kMoves + move)]);
    }
  }
  return distances;
}

std::int64_t LatticeDistances::memory() const {
  std::size_t bytes = 0;
  for (const auto& table : tables_) bytes += table.size() * sizeof(double);
  return static_cast<std::int64_t>(bytes);
}

}  // namespace graspless::fingertip
