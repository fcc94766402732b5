// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/edge_graph.hpp"

namespace graspless::geometry {

/// Dijkstra's shortest paths from one vertex after another, out to a radius. The arrays are used
/// again, so that a search costs what it reaches. The graph must outlive it, and may lose arcs.
class ShortestPaths {
 public:
  explicit ShortestPaths(const EdgeGraph& graph);

  void start(int root);
  /// The next vertex in order of distance, settled; -1 when there is none within `radius` [m].
  int next(double radius);
  /// Looks at the arcs of a vertex that next() gave, before next() is called again. Those that lead
  /// to a settled vertex (the parent too) are handed to `meet`.
  template <class Meet>
  void expand(int vertex, const Meet& meet);
  void expand(int vertex) {
    expand(vertex, [](const EdgeGraph::Arc&) {});
  }

  double distance(int vertex) const { return state_[index(vertex)].distance; }
  int parent(int vertex) const { return state_[index(vertex)].parent; }  ///< -1 at the root
  int via(int vertex) const { return via_[index(vertex)]; }              ///< edge to the parent
  /// From a settled vertex to the root.
  std::vector<int> path(int vertex) const;

 private:
  struct State {
    double distance;
    unsigned stamp;  // 2 epoch: seen, 2 epoch + 1: settled
    int parent;
  };
  struct Item {
    double distance;
    int vertex;
    bool operator<(const Item& other) const {
      return distance > other.distance || (distance == other.distance && vertex > other.vertex);
    }
  };
  static std::size_t index(int vertex) { return static_cast<std::size_t>(vertex); }
  void push(double distance, int vertex);

  const EdgeGraph& graph_;
  unsigned epoch_ = 0;  // of the present root
  std::vector<State> state_;
  std::vector<int> via_;
  std::vector<Item> queue_;
};

template <class Meet>
void ShortestPaths::expand(int vertex, const Meet& meet) {
  const double from = distance(vertex);
  const unsigned seen = 2 * epoch_, settled = seen + 1;
  for (const EdgeGraph::Arc& arc : graph_.arcs(vertex)) {
    State& to = state_[index(arc.to)];
    if (to.stamp == settled) {
      meet(arc);
      continue;
    }
    const double distance = from + arc.length;
    if (to.stamp == seen && distance >= to.distance) continue;
    to = {distance, seen, vertex};
    via_[index(arc.to)] = arc.edge;
    push(distance, arc.to);
  }
}

}  // namespace graspless::geometry
