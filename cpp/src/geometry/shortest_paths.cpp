// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/shortest_paths.hpp"

namespace graspless::geometry {

ShortestPaths::ShortestPaths(const EdgeGraph& graph)
    : graph_(graph),
      state_(static_cast<std::size_t>(graph.num_vertices()), State{0, 0, -1}),
      via_(state_.size()) {}

void ShortestPaths::start(int root) {
  ++epoch_;
  queue_.clear();
  state_[index(root)] = {0, 2 * epoch_, -1};
  via_[index(root)] = -1;
  push(0, root);
}

void ShortestPaths::push(double distance, int vertex) {
  queue_.push_back({distance, vertex});
  std::push_heap(queue_.begin(), queue_.end());
}

int ShortestPaths::next(double radius) {
  while (!queue_.empty()) {
    const Item item = queue_.front();
    if (item.distance > radius) return -1;
    std::pop_heap(queue_.begin(), queue_.end());
    queue_.pop_back();
    State& state = state_[index(item.vertex)];
    if (state.stamp == 2 * epoch_ + 1) continue;
    state.stamp = 2 * epoch_ + 1;
    return item.vertex;
  }
  return -1;
}

std::vector<int> ShortestPaths::path(int vertex) const {
  std::vector<int> vertices;
  for (int v = vertex; v >= 0; v = parent(v)) vertices.push_back(v);
  return vertices;
}

}  // namespace graspless::geometry
