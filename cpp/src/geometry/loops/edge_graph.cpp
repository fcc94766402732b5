// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/edge_graph.hpp"

#include <algorithm>

namespace graspless::geometry {

EdgeGraph::EdgeGraph(const Complex& complex, const std::function<double(int, int)>& weight)
    : first_(static_cast<std::size_t>(complex.points.cols()) + 1, 0) {
  const auto count = static_cast<std::size_t>(complex.edges.cols());
  ends_.resize(count);
  lengths_.resize(count);
  for (std::size_t e = 0; e < count; ++e) {
    const auto column = static_cast<Eigen::Index>(e);
    ends_[e] = {complex.edges(0, column), complex.edges(1, column)};
    lengths_[e] = (complex.points.col(ends_[e].a) - complex.points.col(ends_[e].b)).norm();
    if (weight) lengths_[e] *= weight(ends_[e].a, ends_[e].b);
    ++first_[static_cast<std::size_t>(ends_[e].a) + 1];
    ++first_[static_cast<std::size_t>(ends_[e].b) + 1];
  }
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  last_.assign(first_.begin(), first_.end() - 1);
  arcs_.resize(2 * count);
  const auto add = [&](int from, int to, std::size_t e) {
    const auto place = static_cast<std::size_t>(last_[static_cast<std::size_t>(from)]++);
    arcs_[place] = {to, static_cast<int>(e), lengths_[e]};
  };
  for (std::size_t e = 0; e < count; ++e) {
    add(ends_[e].a, ends_[e].b, e);
    add(ends_[e].b, ends_[e].a, e);
  }
}

int EdgeGraph::edge(int a, int b) const {
  for (const Arc& arc : arcs(a)) {
    if (arc.to == b) return arc.edge;
  }
  return -1;
}

void EdgeGraph::remove(int vertex) {
  for (const Arc& arc : arcs(vertex)) {
    const auto to = static_cast<std::size_t>(arc.to);
    const auto first = arcs_.begin() + first_[to], last = arcs_.begin() + last_[to]--;
    std::swap(*std::find_if(first, last, [&](const Arc& back) { return back.to == vertex; }),
              *(last - 1));
  }
  last_[static_cast<std::size_t>(vertex)] = first_[static_cast<std::size_t>(vertex)];
}

}  // namespace graspless::geometry
