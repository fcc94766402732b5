// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/shortest_basis.hpp"

#include <algorithm>
#include <limits>
#include <queue>

#include "geometry/loops/cycle_basis.hpp"
#include "geometry/loops/rooted_cycles.hpp"

namespace graspless::geometry {
namespace {

/// Vertices that meet every edge of a class, those with the most such edges first: every cycle that
/// is not a boundary runs through one.
std::vector<int> roots(const EdgeGraph& graph, const Annotation& annotation) {
  std::vector<char> is_open(static_cast<std::size_t>(graph.num_edges()));
  std::vector<int> degree(static_cast<std::size_t>(graph.num_vertices()), 0);
  for (int e = 0; e < graph.num_edges(); ++e) {
    if (annotation.is_zero(e)) continue;
    is_open[static_cast<std::size_t>(e)] = 1;
    ++degree[static_cast<std::size_t>(graph.ends(e).a)];
    ++degree[static_cast<std::size_t>(graph.ends(e).b)];
  }
  std::priority_queue<std::pair<int, int>> queue;  // degree, minus the vertex
  for (int v = 0; v < graph.num_vertices(); ++v)
    queue.push({degree[static_cast<std::size_t>(v)], -v});
  std::vector<int> cover;
  while (!queue.empty() && queue.top().first > 0) {
    const auto [count, vertex] = std::pair(queue.top().first, -queue.top().second);
    queue.pop();
    if (count != degree[static_cast<std::size_t>(vertex)]) continue;  // an old entry
    cover.push_back(vertex);
    for (const EdgeGraph::Arc& arc : graph.arcs(vertex)) {
      char& open = is_open[static_cast<std::size_t>(arc.edge)];
      if (!open) continue;
      open = 0;
      --degree[static_cast<std::size_t>(vertex)];
      queue.push({--degree[static_cast<std::size_t>(arc.to)], -arc.to});
    }
  }
  return cover;
}

/// Roots taken one after another, and what each says about those near it.
///
/// Say a cycle of class c and length l at root r would have a place: l is less than bound(c). From
/// a root w at distance s, it is a closed walk of length l + 2 s, made up of w's own closings, none
/// of them longer; one of these has a bound no less than bound(c). So r needs to look no farther
/// than the greatest bound among those of w's closings that exceed it by less than 2 s.
class Search {
 public:
  Search(const Complex& complex, const EdgeGraph& graph, const Annotation& annotation)
      : complex_(complex),
        cycles_(complex, graph, annotation),
        basis_(annotation),
        margin_(complex.max_edge_length),
        limits_(static_cast<std::size_t>(graph.num_vertices()),
                std::numeric_limits<double>::infinity()) {}

  struct Roots {
    std::vector<int>::const_iterator first, last;
  };
  void from(int root, const Roots& rest) {
    const double limit = std::min(this->limit(root), basis_.bound());
    if (limit > 0) {
      const double longest = limit + 2 * margin_;
      const auto& closings = cycles_.from(root, longest);
      for (const RootedCycles::Closing& closing : closings) offer(closing);
      tell(closings, longest, rest);
    }
    cycles_.remove(root);  // what runs through it has been seen
  }
  std::vector<Cycle> cycles() const { return basis_.cycles(); }

 private:
  double& limit(int root) { return limits_[static_cast<std::size_t>(root)]; }

  void offer(const RootedCycles::Closing& closing) {
    const Annotation::Word* cls = cycles_.class_of(closing);
    if (!basis_.has_place(cls, closing.length)) return;
    Cycle cycle = cycles_.cycle(closing);
    const double length = cycle_length(complex_.points, cycle);
    basis_.offer(cls, length, std::move(cycle));
  }

  void tell(const std::vector<RootedCycles::Closing>& closings, double longest, const Roots& rest) {
    bounds_.clear();
    for (const RootedCycles::Closing& closing : closings)
      bounds_.push_back(basis_.bound(cycles_.class_of(closing)));
    for (auto other = rest.first; other != rest.last; ++other) {
      const double detour = 2 * cycles_.distance(*other) * kSlack;
      const double before = std::min(limit(*other), basis_.bound());
      if (before + detour > longest) continue;  // it may see what this root has not
      double most = 0;
      for (std::size_t i = 0; i < closings.size(); ++i) {
        if (bounds_[i] + detour >= closings[i].length) most = std::max(most, bounds_[i]);
      }
      limit(*other) = std::min(before, most);
    }
  }

  static constexpr double kSlack = 1 + 1e-9;  // sums of lengths are rounded
  const Complex& complex_;
  RootedCycles cycles_;
  CycleBasis basis_;
  double margin_;
  std::vector<double> limits_;  // cycles at this root that may have a place are shorter
  std::vector<double> bounds_;
};

}  // namespace

double cycle_length(const Eigen::Matrix3Xd& points, const Cycle& cycle) {
  double length = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i)
    length += (points.col(cycle[i]) - points.col(cycle[(i + 1) % cycle.size()])).norm();
  return length;
}

std::vector<Cycle> shortest_basis(const Complex& complex) {
  const EdgeGraph graph(complex);
  const Annotation annotation(complex, graph);
  Search search(complex, graph, annotation);
  const std::vector<int> all = roots(graph, annotation);
  for (auto root = all.begin(); root != all.end(); ++root)
    search.from(*root, {root + 1, all.end()});
  return search.cycles();
}

}  // namespace graspless::geometry
