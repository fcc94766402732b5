// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/cycles/rooted_cycles.hpp"

#include <algorithm>
#include <tuple>

#include "geometry/pulse.hpp"

namespace graspless::geometry {
namespace {

constexpr double kOverSum = 1 + 1e-9;  // for rounded sums of lengths

}  // namespace

RootedCycles::RootedCycles(const EdgeGraph& graph, const Annotation& annotation)
    : annotation_(annotation),
      paths_(graph),
      words_(annotation.words()),
      path_classes_(words_ == 1 ? 0 : static_cast<std::size_t>(graph.num_vertices()) * words_),
      sum_(words_) {}

bool RootedCycles::is_before(const ClosingEdge& one, const ClosingEdge& other) {
  return std::tie(one.length, one.a, one.b) < std::tie(other.length, other.a, other.b);
}

const std::vector<RootedCycles::ClosingEdge>& RootedCycles::from(int root, double longest) {
  closing_edges_.clear();
  paths_.start(root, longest / 2);
  Pulse pulse;
  for (int v = root; (v = paths_.next()) >= 0;) {
    pulse();
    set_path_class(v);
    paths_.expand(v, [&](const EdgeGraph::Arc& arc) {
      if (is_trivial(v, arc.to, arc.edge)) return;
      const double length = paths_.distance(v) + paths_.distance(arc.to) + arc.length;
      if (length <= longest) closing_edges_.push_back({length, v, arc.to, arc.edge});
    });
  }
  std::sort(closing_edges_.begin(), closing_edges_.end(), is_before);
  return closing_edges_;
}

/// A cycle that a vertex closes is at least twice as long as the vertex is far from the root, so
/// the search ends there.
std::optional<RootedCycles::ClosingEdge> RootedCycles::shortest(int root, double longest,
                                                                const Word* cls) {
  std::optional<ClosingEdge> best;
  Pulse pulse;
  paths_.start(root, longest / 2);
  for (int v = root; (v = paths_.next()) >= 0;) {
    pulse();
    if (best && 2 * paths_.distance(v) > best->length * kOverSum) break;
    set_path_class(v);
    paths_.expand(v, [&](const EdgeGraph::Arc& arc) {
      if (is_trivial(v, arc.to, arc.edge)) return;
      const double length = paths_.distance(v) + paths_.distance(arc.to) + arc.length;
      const ClosingEdge edge{length, v, arc.to, arc.edge};
      if (length > longest || (best && !is_before(edge, *best))) return;
      if (std::equal(cls, cls + words_, class_of(edge))) best = edge;
    });
  }
  return best;
}

void RootedCycles::add_to_path_class(int vertex) {
  const int parent = paths_.parent(vertex);
  if (parent < 0) {
    std::fill_n(path_class(vertex), words_, 0);
    return;
  }
  const Word* cls = annotation_.of(paths_.via(vertex));
  for (std::size_t w = 0; w < words_; ++w) path_class(vertex)[w] = path_class(parent)[w] ^ cls[w];
}

bool RootedCycles::is_trivial_sum(int a, int b, int edge) {
  const Word* cls = annotation_.of(edge);
  for (std::size_t w = 0; w < words_; ++w) {
    if ((path_class(a)[w] ^ path_class(b)[w]) != cls[w]) return false;
  }
  return true;
}

const Annotation::Word* RootedCycles::class_of(const ClosingEdge& edge) {
  const Word* cls = annotation_.of(edge.edge);
  for (std::size_t w = 0; w < words_; ++w)
    sum_[w] = path_class(edge.a)[w] ^ path_class(edge.b)[w] ^ cls[w];
  return sum_.data();
}

/// From one end of the closing edge to where the paths to the root meet, and on to the other end.
Cycle RootedCycles::cycle(const ClosingEdge& edge) const {
  std::vector<int> out = paths_.path(edge.a), back = paths_.path(edge.b);
  while (out.size() > 1 && back.size() > 1 && out[out.size() - 2] == back[back.size() - 2]) {
    out.pop_back();
    back.pop_back();
  }
  back.pop_back();
  out.insert(out.end(), back.rbegin(), back.rend());
  return out;
}

}  // namespace graspless::geometry
