// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/rooted_cycles.hpp"

#include <algorithm>
#include <tuple>

namespace graspless::geometry {

RootedCycles::RootedCycles(const Complex& complex, const EdgeGraph& graph,
                           const Annotation& annotation)
    : annotation_(annotation),
      graph_(graph),
      paths_(graph_),
      words_(static_cast<std::size_t>(annotation.words())),
      is_zero_(static_cast<std::size_t>(complex.edges.cols())),
      ways_(static_cast<std::size_t>(graph.num_vertices()) * words_),
      sum_(words_) {
  for (int e = 0; e < graph.num_edges(); ++e)
    is_zero_[static_cast<std::size_t>(e)] = annotation.is_zero(e);
}

const std::vector<RootedCycles::Closing>& RootedCycles::from(int root, double longest) {
  closings_.clear();
  paths_.start(root, longest / 2);
  for (int v = root; (v = paths_.next()) >= 0;) {
    mark_way(v);
    paths_.expand(v, [&](const EdgeGraph::Arc& arc) {
      if (bounds(v, arc.to, arc.edge)) return;
      const double length = paths_.distance(v) + paths_.distance(arc.to) + arc.length;
      if (length <= longest) closings_.push_back({length, v, arc.to});
    });
  }
  std::sort(closings_.begin(), closings_.end(), [](const Closing& p, const Closing& q) {
    return std::tie(p.length, p.a, p.b) < std::tie(q.length, q.a, q.b);
  });
  return closings_;
}

void RootedCycles::add_to_way(int vertex) {
  const int parent = paths_.parent(vertex);
  if (parent < 0) {
    std::fill_n(way(vertex), words_, 0);
    return;
  }
  const Word* cls = annotation_.of(paths_.via(vertex));
  for (std::size_t w = 0; w < words_; ++w) way(vertex)[w] = way(parent)[w] ^ cls[w];
}

bool RootedCycles::is_boundary(int a, int b, int edge) const {
  const Word* cls = annotation_.of(edge);
  for (std::size_t w = 0; w < words_; ++w) {
    if ((way(a)[w] ^ way(b)[w]) != cls[w]) return false;
  }
  return true;
}

const Annotation::Word* RootedCycles::class_of(const Closing& closing) {
  const Word* cls = annotation_.of(graph_.edge(closing.a, closing.b));
  for (std::size_t w = 0; w < words_; ++w) sum_[w] = way(closing.a)[w] ^ way(closing.b)[w] ^ cls[w];
  return sum_.data();
}

/// From one end of the closing edge to where the ways to the root meet, and out to the other.
Cycle RootedCycles::cycle(const Closing& closing) const {
  std::vector<int> out = paths_.path(closing.a), back = paths_.path(closing.b);
  while (out.size() > 1 && back.size() > 1 && out[out.size() - 2] == back[back.size() - 2]) {
    out.pop_back();
    back.pop_back();
  }
  back.pop_back();
  out.insert(out.end(), back.rbegin(), back.rend());
  return out;
}

}  // namespace graspless::geometry
