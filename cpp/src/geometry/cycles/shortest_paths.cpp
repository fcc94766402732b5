// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/cycles/shortest_paths.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::geometry {

namespace {

constexpr double kBuckets = 32;        // per mean shortest arc of a vertex: each holds few vertices
constexpr double kMostBuckets = 1024;  // per mean arc, where points lie in tight pairs

/// Weights make long arcs so much longer that their mean would put all vertices in few buckets.
double bucket_width(const EdgeGraph& graph) {
  double shortest = 0, all = 0;
  int count = 0;
  for (int e = 0; e < graph.num_edges(); ++e) all += graph.length(e);
  for (int v = 0; v < graph.num_vertices(); ++v) {
    double least = std::numeric_limits<double>::infinity();
    for (const EdgeGraph::Arc& arc : graph.arcs(v)) least = std::min(least, arc.length);
    if (std::isinf(least)) continue;
    shortest += least;
    ++count;
  }
  if (count == 0) return 1;
  return std::max(shortest / count / kBuckets, all / graph.num_edges() / kMostBuckets);
}

}  // namespace

ShortestPaths::ShortestPaths(const EdgeGraph& graph)
    : graph_(graph),
      state_(static_cast<std::size_t>(graph.num_vertices())),
      queue_(bucket_width(graph)) {}

void ShortestPaths::start(int root, double radius) {
  ++epoch_;
  radius_ = radius;
  state_[index(root)] = State();
  state_[index(root)].stamp = 2 * epoch_;
  queue_.clear();
  queue_.push(0, root);
}

int ShortestPaths::next() {
  const unsigned settled = 2 * epoch_ + 1;
  for (BucketQueue::Item item; queue_.pop(item);) {
    State& state = state_[index(item.vertex)];
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
