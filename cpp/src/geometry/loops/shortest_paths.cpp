// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/shortest_paths.hpp"

namespace graspless::geometry {

namespace {

constexpr double kBuckets = 16;  // per mean edge length, so that each holds few vertices

double bucket_width(const EdgeGraph& graph) {
  double sum = 0;
  for (int e = 0; e < graph.num_edges(); ++e) sum += graph.length(e);
  return graph.num_edges() > 0 ? sum / graph.num_edges() / kBuckets : 1;
}

}  // namespace

ShortestPaths::ShortestPaths(const EdgeGraph& graph)
    : graph_(graph),
      state_(static_cast<std::size_t>(graph.num_vertices()), State{0, 0, -1}),
      via_(state_.size()),
      queue_(bucket_width(graph)) {}

void ShortestPaths::start(int root, double radius) {
  ++epoch_;
  radius_ = radius;
  state_[index(root)] = {0, 2 * epoch_, -1};
  via_[index(root)] = -1;
  queue_.clear();
  queue_.push(0, root);
}

int ShortestPaths::next() {
  const unsigned settled = 2 * epoch_ + 1;
  for (BucketQueue::Item item; queue_.pop(item);) {
    State& state = state_[index(item.vertex)];
    if (state.stamp == settled) continue;
    state.stamp = settled;
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
