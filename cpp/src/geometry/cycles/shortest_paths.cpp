// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/cycles/shortest_paths.hpp"

namespace graspless::geometry {

ShortestPaths::ShortestPaths(const EdgeGraph& graph)
    : graph_(graph), state_(graph.num_vertices()), queue_(graph.bucket_width()) {}

void ShortestPaths::start(int root, double radius) {
  ++epoch_;
  radius_ = radius;
  state_[root] = State();
  state_[root].stamp = 2 * epoch_;
  queue_.clear();
  queue_.push(0, root);
}

int ShortestPaths::next() {
  const unsigned settled = 2 * epoch_ + 1;
  for (BucketQueue::Item item; queue_.pop(item);) {
    State& state = state_[item.vertex];
    if (state.stamp == settled) continue;
    state.stamp = settled;
    const int next = queue_.peek();
    if (next >= 0) graph_.prefetch(next);
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
