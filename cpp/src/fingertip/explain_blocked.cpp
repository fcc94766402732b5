// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/explain_blocked.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "graspless/collision/world.hpp"

#include "fingertip/model/clearance.hpp"
#include "fingertip/model/locations.hpp"

namespace graspless::fingertip {
namespace {

using Poses = std::vector<Eigen::Isometry3d>;

Poses needed_poses(const Path& path) { return path.X_WO; }
Poses needed_poses(const Lattice& lattice) { return {lattice.X_WO_start, lattice.X_WO_goal}; }
Poses needed_poses(const Goal& goal) { return {goal.X_WO_start, goal.X_WO_goal}; }

/// Whether `count` more locations apart from `chosen` and each other are among clear[from ...].
bool fit(const Locations& locations, const std::vector<int>& clear, std::size_t from, int count,
         std::vector<int>& chosen) {
  if (count == 0) return true;
  for (std::size_t i = from; i < clear.size(); ++i) {
    const bool apart = std::all_of(chosen.begin(), chosen.end(),
                                   [&](int other) { return locations.are_apart(clear[i], other); });
    if (!apart) continue;
    chosen.push_back(clear[i]);
    if (fit(locations, clear, i + 1, count - 1, chosen)) return true;
    chosen.pop_back();
  }
  return false;
}

/// How many locations each plane and all obstacles keep the fingertips from.
std::string in_the_way(const Problem& problem, const Locations& locations,
                       const Eigen::Isometry3d& X_WO) {
  std::ostringstream out;
  const auto count = [&](const std::string& who, const Problem& alone) {
    Clearance clearance(alone);
    int blocked = 0;
    for (int i = 0; i < locations.size(); ++i) {
      blocked += clearance.is_clear(X_WO * locations[i].center_O) ? 0 : 1;
    }
    if (blocked == 0) return;
    out << (out.tellp() > 0 ? ", " : "") << who << " blocks " << blocked;
  };
  Problem alone = problem;
  alone.obstacles.clear();
  for (const Plane& plane : problem.planes) {
    alone.planes = {plane};
    count("plane '" + plane.name + "'", alone);
  }
  alone.planes.clear();
  for (const Obstacle& obstacle : problem.obstacles) {
    alone.obstacles = {obstacle};
    count("obstacle '" + obstacle.name + "'", alone);
  }
  return out.str();
}

}  // namespace

std::optional<Blocked> find_blocked(const Problem& problem, const Options& options) {
  const Locations locations(problem.object, problem.fingers, options);
  const Poses poses =
      std::visit([](const auto& motion) { return needed_poses(motion); }, problem.motion);
  Clearance clearance(problem);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    std::vector<int> clear, chosen;
    for (int i = 0; i < locations.size(); ++i) {
      if (clearance.is_clear(poses[k] * locations[i].center_O)) clear.push_back(i);
    }
    if (fit(locations, clear, 0, problem.fingers.count, chosen)) continue;
    std::ostringstream reason;
    reason << "at pose " << k << " of " << poses.size() << " ";
    if (clear.empty()) {
      reason << "no fingertip location is clear";
    } else {
      reason << "only " << clear.size() << " fingertip locations are clear, with no place for "
             << problem.fingers.count << " fingers apart";
    }
    reason << ": of " << locations.size() << " locations "
           << in_the_way(problem, locations, poses[k]);
    return Blocked{clear.empty() ? "reach of the lattice" : "geometry", reason.str()};
  }
  return std::nullopt;
}

}  // namespace graspless::fingertip
