// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/shortest_basis.hpp"

#include <queue>

#include "geometry/cycle_basis.hpp"
#include "geometry/rooted_cycles.hpp"

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
  CycleBasis basis(annotation);
  if (annotation.num_classes() == 0) return {};
  RootedCycles cycles(complex, graph, annotation);
  for (const int root : roots(graph, annotation)) {
    for (const RootedCycles::Closing& closing : cycles.from(root, basis.bound())) {
      const Annotation::Word* cls = cycles.class_of(closing);
      if (!basis.has_place(cls, closing.length)) continue;
      Cycle cycle = cycles.cycle(closing);
      const double length = cycle_length(complex.points, cycle);
      basis.offer(cls, length, std::move(cycle));
    }
    cycles.remove(root);  // what runs through it has been seen
  }
  return basis.cycles();
}

}  // namespace graspless::geometry
