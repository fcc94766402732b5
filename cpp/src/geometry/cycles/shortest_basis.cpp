// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/cycles/shortest_basis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "graspless/watch.hpp"

#include "geometry/cycles/cycle_basis.hpp"
#include "geometry/cycles/rooted_cycles.hpp"

namespace graspless::geometry {
namespace {

/// A greedy vertex cover of the edges with nonzero labels. Every nontrivial cycle runs through one
/// of its vertices.
std::vector<int> roots(const EdgeGraph& graph, const Annotation& annotation) {
  std::vector<char> is_open(graph.num_edges());
  std::vector<int> degree(graph.num_vertices(), 0);
  for (int e = 0; e < graph.num_edges(); ++e) {
    if (annotation.is_zero(e)) continue;
    is_open[e] = 1;
    ++degree[graph.ends(e).a];
    ++degree[graph.ends(e).b];
  }
  std::priority_queue<std::pair<int, int>> queue;  // (degree, -vertex)
  for (int v = 0; v < graph.num_vertices(); ++v) queue.push({degree[v], -v});
  std::vector<int> cover;
  while (!queue.empty() && queue.top().first > 0) {
    poll();
    const auto [count, vertex] = std::pair(queue.top().first, -queue.top().second);
    queue.pop();
    if (count != degree[vertex]) continue;  // outdated entry
    cover.push_back(vertex);
    for (const EdgeGraph::Arc& arc : graph.arcs(vertex)) {
      char& open = is_open[arc.edge];
      if (!open) continue;
      open = 0;
      --degree[vertex];
      queue.push({--degree[arc.to], -arc.to});
    }
  }
  return cover;
}

/// Processes roots in turn. Each root limits the search radius of the roots near it.
///
/// Let a cycle of class c and length l through root r improve the basis: l < bound(c). Seen from a
/// root w at distance s, it is a closed walk of length l + 2 s. It is a sum of cycles of w's
/// closing edges, none of them longer, and one of these has a bound of at least bound(c). So r must
/// search only up to the largest bound among those closing edges of w whose length is less than
/// their bound plus 2 s.
class Search {
 public:
  Search(const Complex& complex, const EdgeGraph& graph, const Annotation& annotation)
      : complex_(complex),
        graph_(graph),
        cycles_(graph_, annotation),
        basis_(annotation),
        margin_(complex.max_edge_length),
        limits_(graph.num_vertices(), std::numeric_limits<double>::infinity()) {}

  struct Roots {
    std::vector<int>::const_iterator first, last;
  };
  void from(int root, const Roots& rest) {
    const double limit = std::min(this->limit(root), basis_.bound());
    if (limit > 0) {
      const double longest = limit + 2 * margin_;
      const auto& edges = cycles_.from(root, longest);
      for (const RootedCycles::ClosingEdge& edge : edges) {
        poll();
        offer(edge);
      }
      limit_others(edges, longest, rest);
    }
    graph_.remove(root);  // all cycles through it have been offered
  }
  std::vector<ClassCycle> cycles() const { return basis_.cycles(); }

 private:
  double& limit(int root) { return limits_[root]; }

  void offer(const RootedCycles::ClosingEdge& edge) {
    const Annotation::Word* cls = cycles_.class_of(edge);
    if (!basis_.would_improve(cls, edge.length)) return;
    Cycle cycle = cycles_.cycle(edge);
    const double length = cycle_length(complex_.points, cycle);
    basis_.offer(cls, length, std::move(cycle));
  }

  void limit_others(const std::vector<RootedCycles::ClosingEdge>& edges, double longest,
                    const Roots& rest) {
    bounds_.clear();
    for (const RootedCycles::ClosingEdge& edge : edges)
      bounds_.push_back(basis_.bound(cycles_.class_of(edge)));
    for (auto other = rest.first; other != rest.last; ++other) {
      poll();
      const double detour = 2 * cycles_.distance(*other) * kSlack;
      if (std::isinf(detour)) continue;  // it sees other cycles
      const double before = std::min(limit(*other), basis_.bound());
      if (before + detour > longest) continue;  // it may find cycles that this root did not
      double longest_bound = 0;
      for (std::size_t i = 0; i < edges.size(); ++i) {
        if (bounds_[i] + detour >= edges[i].length)
          longest_bound = std::max(longest_bound, bounds_[i]);
      }
      limit(*other) = std::min(before, longest_bound);
    }
  }

  static constexpr double kSlack = 1 + 1e-9;  // for rounded sums of lengths
  const Complex& complex_;
  EdgeGraph graph_;
  RootedCycles cycles_;
  CycleBasis basis_;
  double margin_;
  std::vector<double> limits_;  // per root: cycles through it that improve the basis are shorter
  std::vector<double> bounds_;
};

}  // namespace

double cycle_length(const Eigen::Matrix3Xd& points, const Cycle& cycle) {
  double length = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i)
    length += (points.col(cycle[i]) - points.col(cycle[(i + 1) % cycle.size()])).norm();
  return length;
}

namespace {

std::vector<ClassCycle> basis_of(const Complex& complex, const EdgeGraph& graph,
                                 const Annotation& annotation) {
  Search search(complex, graph, annotation);
  const std::vector<int> all = roots(graph, annotation);
  for (auto root = all.begin(); root != all.end(); ++root) {
    poll();
    search.from(*root, {root + 1, all.end()});
  }
  return search.cycles();
}

}  // namespace

std::vector<Cycle> shortest_basis(const Complex& complex) {
  const EdgeGraph graph(complex);
  std::vector<Cycle> cycles;
  for (ClassCycle& member : basis_of(complex, graph, Annotation(complex, graph)))
    cycles.push_back(std::move(member.cycle));
  return cycles;
}

std::vector<ClassCycle> shortest_basis(const Complex& complex, ClassLabels labels) {
  return basis_of(complex, EdgeGraph(complex), Annotation(std::move(labels)));
}

}  // namespace graspless::geometry
