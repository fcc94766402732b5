// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/cycles/bucket_queue.hpp"
#include "geometry/cycles/edge_graph.hpp"

namespace graspless::geometry {

/// Dijkstra's algorithm from many roots in turn, each within a radius. Arrays are reused, so the
/// cost of a search depends only on the vertices it reaches. The graph must outlive this object.
/// Its arcs may be removed between searches.
class ShortestPaths {
 public:
  explicit ShortestPaths(const EdgeGraph& graph);

  /// Starts a search that ignores vertices farther than `radius` [m] from the root.
  void start(int root, double radius);
  /// Settles and returns the next vertex in order of distance, or -1 if there is none left.
  int next();
  /// Relaxes the arcs of the vertex last returned by next(). Arcs to settled vertices, the parent
  /// included, are passed to `meet`.
  template <class Meet>
  void expand(int vertex, const Meet& meet);
  void expand(int vertex) {
    expand(vertex, [](const EdgeGraph::Arc&) {});
  }

  double distance(int vertex) const { return state_[vertex].distance; }
  /// Same for any vertex; infinite if it is not settled.
  double reached_distance(int vertex) const {
    return state_[vertex].stamp == 2 * epoch_ + 1 ? distance(vertex)
                                                  : std::numeric_limits<double>::infinity();
  }
  int parent(int vertex) const { return state_[vertex].parent; }  ///< -1 for the root
  int via(int vertex) const { return state_[vertex].via; }        ///< edge to the parent
  /// A word for each vertex that the caller sets and reads.
  std::uint64_t& tag(int vertex) { return state_[vertex].tag; }
  /// Vertices from a settled vertex to the root.
  std::vector<int> path(int vertex) const;

 private:
  struct State {
    double distance = 0;
    std::uint64_t tag = 0;
    unsigned stamp = 0;  // 2 epoch: reached, 2 epoch + 1: settled
    int parent = -1, via = -1;
    int unused = 0;  // two states fill a cache line
  };

  const EdgeGraph& graph_;
  unsigned epoch_ = 0;  // number of searches started
  double radius_ = 0;
  std::vector<State> state_;
  BucketQueue queue_;
};

template <class Meet>
void ShortestPaths::expand(int vertex, const Meet& meet) {
  const double from = distance(vertex);
  const unsigned seen = 2 * epoch_, settled = seen + 1;
  for (const EdgeGraph::Arc& arc : graph_.arcs(vertex)) {
    State& to = state_[arc.to];
    if (to.stamp == settled) {
      meet(arc);
      continue;
    }
    const double distance = from + arc.length;
    if (distance > radius_ || (to.stamp == seen && distance >= to.distance)) continue;
    to.distance = distance;
    to.stamp = seen;
    to.parent = vertex;
    to.via = arc.edge;
    queue_.push(distance, arc.to);
  }
}

}  // namespace graspless::geometry
