// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/root_components.hpp"

#include <algorithm>
#include <deque>
#include <map>

namespace graspless::planning {

std::size_t RootComponents::component_of(bool is_start, int root) {
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const auto& members = is_start ? components_[i].starts : components_[i].goals;
    if (std::find(members.begin(), members.end(), root) != members.end()) return i;
  }
  components_.emplace_back();
  (is_start ? components_.back().starts : components_.back().goals).push_back(root);
  return components_.size() - 1;
}

std::vector<std::pair<int, int>> RootComponents::join(const Bridge& bridge) {
  bridges_.push_back(bridge);
  const std::size_t a = component_of(true, bridge.start_root);
  const std::size_t b = component_of(false, bridge.goal_root);
  if (a == b) return {};
  const Component left = components_[a], right = components_[b];
  std::vector<std::pair<int, int>> fresh;
  for (int s : left.starts) {
    for (int g : right.goals) fresh.emplace_back(s, g);
  }
  for (int s : right.starts) {
    for (int g : left.goals) fresh.emplace_back(s, g);
  }
  Component& merged = components_[a];
  merged.starts.insert(merged.starts.end(), right.starts.begin(), right.starts.end());
  merged.goals.insert(merged.goals.end(), right.goals.begin(), right.goals.end());
  components_.erase(components_.begin() + b);
  return fresh;
}

std::vector<Bridge> RootComponents::route(int start_root, int goal_root) const {
  // Breadth first over roots: starts as (true, root), goals as (false, root).
  using Root = std::pair<bool, int>;
  const Root from{true, start_root}, to{false, goal_root};
  std::map<Root, const Bridge*> reached{{from, nullptr}};
  std::deque<Root> queue{from};
  while (!queue.empty() && reached.find(to) == reached.end()) {
    const Root at = queue.front();
    queue.pop_front();
    for (const Bridge& bridge : bridges_) {
      if ((at.first ? bridge.start_root : bridge.goal_root) != at.second) continue;
      const Root next{!at.first, at.first ? bridge.goal_root : bridge.start_root};
      if (reached.emplace(next, &bridge).second) queue.push_back(next);
    }
  }
  std::vector<Bridge> route;
  if (reached.find(to) == reached.end()) return route;
  for (Root at = to; at != from;) {
    const Bridge& bridge = *reached.at(at);
    route.push_back(bridge);
    at = {!at.first, at.first ? bridge.goal_root : bridge.start_root};
  }
  std::reverse(route.begin(), route.end());
  return route;
}

}  // namespace graspless::planning
