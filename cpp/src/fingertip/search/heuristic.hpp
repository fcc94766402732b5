// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "fingertip/model/pose_graph.hpp"

namespace graspless::fingertip {

/// Shortest displacement of a fingertip from each pose to the goal: |Delta q*| of (11), round what
/// stops the object and whatever its stability. One Dijkstra search backwards for each location, on
/// first use. In a lattice, locations one above the other share a table.
class RemainingDistance {
 public:
  explicit RemainingDistance(const PoseGraph& graph);

  /// Distances from all poses [m]; infinite where a route from the start over that pose costs
  /// `limit` or more. Limits may only fall from call to call.
  const double* to_goal(int location, double limit = std::numeric_limits<double>::infinity()) {
    const int representative = table_of_[location];
    std::vector<double>& table = tables_[representative];
    if (table.empty()) table = search(representative, limit);
    return table.data();
  }

  std::int64_t memory() const;  // [bytes]

 private:
  std::vector<double> search(int location, double limit);

  const PoseGraph& graph_;
  std::vector<int> table_of_;  // locations
  std::vector<std::vector<double>> tables_;
  std::vector<int> pose_of_turn_;           // turns: the first pose turned so
  std::vector<Eigen::Vector3d> origins_W_;  // poses: of O, apart from X_WO for the cache's sake
};

/// Heuristic (11), made admissible and consistent: a regrasp may be cheaper than to carry the
/// fingers all the way.
class Heuristic {
 public:
  Heuristic(const PoseGraph& graph, RemainingDistance& remaining, double greed = 1);
  /// Least cost from a node, or from a hub and so from what it leads to at best, to the goal [m];
  /// infinite if the goal is out of reach. With greed above 1: what the search ranks nodes by.
  double operator()(const Node& node) const;

 private:
  const PoseGraph& graph_;
  double greed_;
  RemainingDistance& remaining_;
};

}  // namespace graspless::fingertip
