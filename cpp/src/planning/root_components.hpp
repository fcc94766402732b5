// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

namespace graspless::planning {

/// A connection of a start tree and a goal tree: two nodes at the same state, and their roots.
struct Bridge {
  int start_node, goal_node;
  int start_root, goal_root;
};

/// Connected components of roots: trees joined by any chain of bridges.
class RootComponents {
 public:
  /// Adds a bridge; returns the (start root, goal root) pairs that were not connected before.
  std::vector<std::pair<int, int>> join(const Bridge& bridge);

  /// Returns the bridges on a shortest route from a start root to a goal root of the same
  /// component.
  std::vector<Bridge> route(int start_root, int goal_root) const;

 private:
  struct Component {
    std::vector<int> starts, goals;
  };
  std::size_t component_of(bool is_start, int root);

  std::vector<Component> components_;
  std::vector<Bridge> bridges_;
};

}  // namespace graspless::planning
