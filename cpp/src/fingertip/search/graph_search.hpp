// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "fingertip/model/path_query.hpp"
#include "fingertip/search/node_table.hpp"

namespace graspless::fingertip {

/// A node of the graph as one number: pose, placement and the number of regrasps so far (where
/// that is limited). A placement with fewer fingers than the hand has is a hub: those that a
/// regrasp keeps.
class NodeCode {
 public:
  /// Throws std::invalid_argument when there are more nodes than numbers.
  NodeCode(int num_poses, int num_locations, int num_fingers, int num_layers);
  std::uint64_t pack(const Node& node, int layer) const;
  Node unpack(std::uint64_t code, int* layer) const;

 private:
  std::uint64_t base_, layers_;
  int num_fingers_;
};

/// Heuristic (11), made admissible and consistent: a regrasp may be cheaper than to carry the
/// fingers all the way.
class Heuristic {
 public:
  Heuristic(const PathQuery& query, bool is_on);
  /// Of a node, or of a hub: then of what it leads to at best.
  double operator()(const Node& node) const;

 private:
  const PathQuery& query_;
  bool is_on_;
  std::vector<double> remaining_;  // displacement to the goal, poses x locations
};

}  // namespace graspless::fingertip
