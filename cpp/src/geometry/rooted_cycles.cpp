// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/rooted_cycles.hpp"

#include <algorithm>

namespace graspless::geometry {

RootedCycles::RootedCycles(const Complex& complex, const EdgeGraph& graph,
                           const Annotation& annotation)
    : complex_(complex),
      graph_(graph),
      annotation_(annotation),
      paths_(graph),
      words_(static_cast<std::size_t>(annotation.words())),
      classes_(static_cast<std::size_t>(graph.num_vertices()) * words_),
      sum_(words_) {}

void RootedCycles::add_class(Annotation::Word* to, const Annotation::Word* cls) const {
  for (std::size_t w = 0; w < words_; ++w) to[w] ^= cls[w];
}

void RootedCycles::from(int root, const Radius& radius, const IsWanted& is_wanted,
                        const Take& take) {
  paths_.start(root);
  for (int v = root; (v = paths_.next(radius())) >= 0;) {
    const int parent = paths_.parent(v);
    if (parent < 0) {
      std::fill_n(class_of(v), words_, 0);
    } else {
      std::copy_n(class_of(parent), words_, class_of(v));
      add_class(class_of(v), annotation_.of(paths_.via(v)));
    }
    for (const EdgeGraph::Arc& arc : graph_.arcs(v)) {
      if (arc.edge != paths_.via(v) && paths_.is_settled(arc.to)) close(v, arc, is_wanted, take);
    }
  }
}

void RootedCycles::close(int vertex, const EdgeGraph::Arc& arc, const IsWanted& is_wanted,
                         const Take& take) {
  std::copy_n(class_of(vertex), words_, sum_.data());
  add_class(sum_.data(), class_of(arc.to));
  add_class(sum_.data(), annotation_.of(arc.edge));
  if (std::all_of(sum_.begin(), sum_.end(), [](auto word) { return word == 0; })) return;
  const double length = paths_.distance(vertex) + paths_.distance(arc.to) + arc.length;
  if (!is_wanted(length, sum_.data())) return;
  Cycle found = cycle(vertex, arc.to);
  const double shortened = cycle_length(complex_.points, found);
  take(sum_.data(), shortened, std::move(found));
}

/// From one end of the closing edge to where the ways to the root meet, and out to the other.
Cycle RootedCycles::cycle(int a, int b) const {
  std::vector<int> out = paths_.path(a), back = paths_.path(b);
  while (out.size() > 1 && back.size() > 1 && out[out.size() - 2] == back[back.size() - 2]) {
    out.pop_back();
    back.pop_back();
  }
  back.pop_back();
  out.insert(out.end(), back.rbegin(), back.rend());
  return out;
}

}  // namespace graspless::geometry
