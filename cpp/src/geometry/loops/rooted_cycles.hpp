// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/loops/annotation.hpp"
#include "geometry/loops/shortest_basis.hpp"
#include "geometry/loops/shortest_paths.hpp"

namespace graspless::geometry {

/// The cycles of an edge and the shortest paths from a root to its ends, with their classes: among
/// those of enough roots are the shortest of every class (Horton 1987; Dey, Sun, Wang 2010).
class RootedCycles {
 public:
  /// An edge that closes a cycle which does not bound.
  struct Closing {
    double length;  // of the edge and both ways to the root [m]
    int a, b;
  };

  RootedCycles(const Complex& complex, const EdgeGraph& graph, const Annotation& annotation);

  /// Those of at most `longest` [m] from a root, shortest first; good until the next call.
  const std::vector<Closing>& from(int root, double longest);
  /// Of the last root. Good until the next call.
  const Annotation::Word* class_of(const Closing& closing);
  /// Of the last root, without the stretch that both ways share.
  Cycle cycle(const Closing& closing) const;
  /// Of the last root, from it [m]; infinite beyond half of `longest`.
  double distance(int vertex) const { return paths_.reached_distance(vertex); }
  /// No way runs through this vertex from now on.
  void remove(int vertex) { graph_.remove(vertex); }

 private:
  using Word = Annotation::Word;

  void mark_way(int vertex) {
    const int parent = paths_.parent(vertex), via = paths_.via(vertex);
    if (words_ == 1 && parent >= 0 && is_zero_[static_cast<std::size_t>(via)]) {
      *way(vertex) = *way(parent);
    } else {
      add_to_way(vertex);
    }
  }
  void add_to_way(int vertex);
  /// Whether both ways to the root and the edge between their ends are a boundary together.
  bool bounds(int a, int b, int edge) const {
    if (words_ == 1 && is_zero_[static_cast<std::size_t>(edge)]) return *way(a) == *way(b);
    return is_boundary(a, b, edge);
  }
  bool is_boundary(int a, int b, int edge) const;
  Word* way(int vertex) { return ways_.data() + static_cast<std::size_t>(vertex) * words_; }
  const Word* way(int vertex) const {
    return ways_.data() + static_cast<std::size_t>(vertex) * words_;
  }

  const Annotation& annotation_;
  EdgeGraph graph_;
  ShortestPaths paths_;
  std::size_t words_;
  std::vector<char> is_zero_;  // an edge's class
  std::vector<Word> ways_;     // classes of the ways from the root to settled vertices
  std::vector<Word> sum_;
  std::vector<Closing> closings_;
};

}  // namespace graspless::geometry
