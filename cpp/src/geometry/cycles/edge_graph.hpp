// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "graspless/geometry/complex.hpp"

namespace graspless::geometry {

/// Factor of the length of the edge between two points.
using EdgeWeight = std::function<double(int, int)>;

/// Adjacency lists of the points of a complex.
class EdgeGraph {
 public:
  struct Arc {
    int to, edge;
    double length;  // times the weight [m]
  };
  struct Arcs {
    const Arc *first, *last;
    const Arc* begin() const { return first; }
    const Arc* end() const { return last; }
  };

  explicit EdgeGraph(const Complex& complex, const EdgeWeight& weight = {});

  int num_vertices() const { return static_cast<int>(first_.size()) - 1; }
  int num_edges() const { return static_cast<int>(ends_.size()); }
  Arcs arcs(int vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return {arcs_.data() + first_[v], arcs_.data() + last_[v]};
  }
  /// Begins to load the arcs of a vertex that is about to be visited.
  void prefetch(int vertex) const {
    const Arcs range = arcs(vertex);
    for (const Arc* arc = range.first; arc < range.last; arc += 64 / sizeof(Arc))
      __builtin_prefetch(arc);
  }
  struct Ends {
    int a, b;
  };
  Ends ends(int edge) const { return ends_[edge]; }
  double length(int edge) const { return lengths_[edge]; }
  /// Width of buckets of distances that hold few vertices each [m].
  double bucket_width() const { return bucket_width_; }
  /// Index of the edge between two vertices, or -1.
  int edge(int a, int b) const;
  /// Removes all arcs to and from a vertex. The edges keep their indices.
  void remove(int vertex);

 private:
  double narrow() const;

  std::vector<int> first_, last_;  // range of each vertex in arcs_; first_ has one more entry
  std::vector<int> first_edge_;    // of each smaller end, and the number of edges
  std::vector<Arc> arcs_;
  std::vector<Ends> ends_;
  std::vector<double> lengths_;
  double bucket_width_ = 1;
};

}  // namespace graspless::geometry
