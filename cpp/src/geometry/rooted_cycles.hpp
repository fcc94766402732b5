// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "geometry/annotation.hpp"
#include "geometry/shortest_basis.hpp"
#include "geometry/shortest_paths.hpp"

namespace graspless::geometry {

/// The cycles of an edge and the shortest paths from a root to its ends, with their classes: among
/// those of enough roots are the shortest of every class (Horton 1987; Dey, Sun, Wang 2010).
class RootedCycles {
 public:
  RootedCycles(const Complex& complex, const EdgeGraph& graph, const Annotation& annotation);

  /// Asked of every edge that closes a cycle: what it comes to with the ways to the root, and the
  /// class. True where the cycle itself is wanted.
  using IsWanted = std::function<bool(double length, const Annotation::Word* cls)>;
  /// A cycle that was wanted, without the stretch that both ways share.
  using Take = std::function<void(const Annotation::Word* cls, double length, Cycle cycle)>;
  /// How far to look from the root [m]; asked again and again.
  using Radius = std::function<double()>;

  void from(int root, const Radius& radius, const IsWanted& is_wanted, const Take& take);
  /// Ways avoid this vertex from now on.
  void remove(int vertex) { paths_.remove(vertex); }

 private:
  void close(int vertex, const EdgeGraph::Arc& arc, const IsWanted& is_wanted, const Take& take);
  void add_class(Annotation::Word* to, const Annotation::Word* cls) const;
  Annotation::Word* class_of(int vertex) {
    return classes_.data() + static_cast<std::size_t>(vertex) * words_;
  }
  Cycle cycle(int a, int b) const;

  const Complex& complex_;
  const EdgeGraph& graph_;
  const Annotation& annotation_;
  ShortestPaths paths_;
  std::size_t words_;
  std::vector<Annotation::Word> classes_;  // of the way from the root to a settled vertex
  std::vector<Annotation::Word> sum_;
};

}  // namespace graspless::geometry
