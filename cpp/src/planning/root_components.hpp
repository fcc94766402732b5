// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

namespace graspless::planning {

/// Where a start tree and a goal tree meet: two nodes at one state, and their roots.
struct Bridge {
  int start_node, goal_node;
  int start_root, goal_root;
};

/// Which roots hang together: two trees joined by a bridge, and all that are joined with either.
class RootComponents {
 public:
  /// Adds a bridge; returns the (start root, goal root) pairs that were not connected before.
  std::vector<std::pair<int, int>> join(const Bridge& bridge);

  /// The bridges to cross from a start root to a goal root of its component, fewest first.
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
