// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "geometry/edge_graph.hpp"

namespace graspless::geometry {

/// Dijkstra's shortest paths from one vertex after another, out to a radius. The arrays are used
/// again, so that a search costs what it reaches.
class ShortestPaths {
 public:
  explicit ShortestPaths(const EdgeGraph& graph);

  /// Paths avoid this vertex from now on.
  void remove(int vertex) { is_removed_[static_cast<std::size_t>(vertex)] = 1; }

  void start(int root);
  /// The next vertex in order of distance; -1 when there is none within `radius` [m].
  int next(double radius);

  bool is_settled(int vertex) const { return reached_[index(vertex)] == 2 * epoch_ + 1; }
  double distance(int vertex) const { return distance_[index(vertex)]; }
  int parent(int vertex) const { return parent_[index(vertex)]; }  ///< -1 at the root
  int via(int vertex) const { return via_[index(vertex)]; }        ///< edge to the parent
  /// From a settled vertex to the root.
  std::vector<int> path(int vertex) const;

 private:
  struct Item {
    double distance;
    int vertex;
    bool operator<(const Item& other) const {
      return distance > other.distance || (distance == other.distance && vertex > other.vertex);
    }
  };
  static std::size_t index(int vertex) { return static_cast<std::size_t>(vertex); }
  void relax(int vertex);

  const EdgeGraph& graph_;
  unsigned epoch_ = 0;             // of the present root
  std::vector<unsigned> reached_;  // 2 epoch: seen, 2 epoch + 1: settled
  std::vector<char> is_removed_;
  std::vector<double> distance_;
  std::vector<int> parent_, via_;
  std::vector<Item> queue_;
};

}  // namespace graspless::geometry
