// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geometry/cycles/annotation.hpp"
#include "geometry/cycles/shortest_basis.hpp"
#include "geometry/cycles/shortest_paths.hpp"

namespace graspless::geometry {

/// Cycles formed by an edge and the shortest paths from a root to its ends, with their classes in
/// H_1. With enough roots they include a shortest cycle of every class (Horton 1987; Dey, Sun, Wang
/// 2010).
class RootedCycles {
 public:
  /// An edge that closes a nontrivial cycle.
  struct ClosingEdge {
    double length;   // of the edge and both paths to the root [m]
    int a, b, edge;  // the edge and its ends, the one farther from the root first
  };

  /// Graph and labels must outlive this object. Arcs of the graph may be removed between calls.
  RootedCycles(const EdgeGraph& graph, const Annotation& annotation);

  /// Closing edges of the nontrivial cycles of at most `longest` [m] through a root, shortest
  /// first. Valid until the next call.
  const std::vector<ClosingEdge>& from(int root, double longest);
  /// The first of these edges whose cycle has a given class.
  std::optional<ClosingEdge> shortest(int root, double longest, const Annotation::Word* cls);
  /// Class of the cycle of a closing edge of the last root. Valid until the next call.
  const Annotation::Word* class_of(const ClosingEdge& edge);
  /// The cycle of a closing edge of the last root, without the part that both paths share.
  Cycle cycle(const ClosingEdge& edge) const;
  /// Distance of a vertex to the last root [m]; infinite beyond half of `longest`.
  double distance(int vertex) const { return paths_.reached_distance(vertex); }

 private:
  using Word = Annotation::Word;
  static bool is_before(const ClosingEdge& one, const ClosingEdge& other);

  void set_path_class(int vertex) {
    const int parent = paths_.parent(vertex), via = paths_.via(vertex);
    if (words_ == 1 && parent >= 0 && annotation_.is_zero(via)) {
      paths_.tag(vertex) = paths_.tag(parent);
    } else {
      add_to_path_class(vertex);
    }
  }
  void add_to_path_class(int vertex);
  /// True if an edge and the paths from its ends to the root form a boundary.
  bool is_trivial(int a, int b, int edge) {
    if (words_ == 1 && annotation_.is_zero(edge)) return paths_.tag(a) == paths_.tag(b);
    return is_trivial_sum(a, b, edge);
  }
  bool is_trivial_sum(int a, int b, int edge);
  Word* path_class(int vertex) {
    return words_ == 1 ? &paths_.tag(vertex)
                       : path_classes_.data() + static_cast<std::size_t>(vertex) * words_;
  }

  const Annotation& annotation_;
  ShortestPaths paths_;
  std::size_t words_;
  /// Classes of the paths from the root to settled vertices. Those of one word are tags of paths_.
  std::vector<Word> path_classes_;
  std::vector<Word> sum_;
  std::vector<ClosingEdge> closing_edges_;
};

}  // namespace graspless::geometry
