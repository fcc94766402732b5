// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/shortest_paths.hpp"

#include <algorithm>

namespace graspless::geometry {

ShortestPaths::ShortestPaths(const EdgeGraph& graph)
    : graph_(graph),
      reached_(static_cast<std::size_t>(graph.num_vertices()), 0),
      is_removed_(reached_.size(), 0),
      distance_(reached_.size()),
      parent_(reached_.size()),
      via_(reached_.size()) {}

void ShortestPaths::start(int root) {
  ++epoch_;
  queue_.clear();
  reached_[index(root)] = 2 * epoch_;
  distance_[index(root)] = 0;
  parent_[index(root)] = via_[index(root)] = -1;
  queue_.push_back({0, root});
}

int ShortestPaths::next(double radius) {
  while (!queue_.empty()) {
    const Item item = queue_.front();
    if (item.distance > radius) return -1;
    std::pop_heap(queue_.begin(), queue_.end());
    queue_.pop_back();
    if (is_settled(item.vertex)) continue;
    reached_[index(item.vertex)] = 2 * epoch_ + 1;
    relax(item.vertex);
    return item.vertex;
  }
  return -1;
}

void ShortestPaths::relax(int vertex) {
  const double from = distance(vertex);
  for (const EdgeGraph::Arc& arc : graph_.arcs(vertex)) {
    const std::size_t to = index(arc.to);
    if (reached_[to] == 2 * epoch_ + 1 || is_removed_[to]) continue;
    const double length = from + arc.length;
    if (reached_[to] == 2 * epoch_ && length >= distance_[to]) continue;
    reached_[to] = 2 * epoch_;
    distance_[to] = length;
    parent_[to] = vertex;
    via_[to] = arc.edge;
    queue_.push_back({length, arc.to});
    std::push_heap(queue_.begin(), queue_.end());
  }
}

std::vector<int> ShortestPaths::path(int vertex) const {
  std::vector<int> vertices;
  for (int v = vertex; v >= 0; v = parent(v)) vertices.push_back(v);
  return vertices;
}

}  // namespace graspless::geometry
