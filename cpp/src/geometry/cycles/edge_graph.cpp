// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/cycles/edge_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace graspless::geometry {
namespace {

constexpr double kBuckets = 32;        // per mean shortest arc of a vertex: each holds few vertices
constexpr double kMostBuckets = 1024;  // per mean arc, where points lie in tight pairs

}  // namespace

EdgeGraph::EdgeGraph(const Complex& complex, const EdgeWeight& weight)
    : first_(static_cast<std::size_t>(complex.points.cols()) + 1, 0), first_edge_(first_) {
  const auto count = static_cast<std::size_t>(complex.edges.cols());
  ends_.resize(count);
  lengths_.resize(count);
  for (std::size_t e = 0; e < count; ++e) {
    const auto column = static_cast<Eigen::Index>(e);
    ends_[e] = {complex.edges(0, column), complex.edges(1, column)};
    lengths_[e] = (complex.points.col(ends_[e].a) - complex.points.col(ends_[e].b)).norm();
    if (weight) lengths_[e] *= weight(ends_[e].a, ends_[e].b);
    ++first_edge_[static_cast<std::size_t>(ends_[e].a) + 1];
    ++first_[static_cast<std::size_t>(ends_[e].a) + 1];
    ++first_[static_cast<std::size_t>(ends_[e].b) + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::partial_sum(first_edge_.begin(), first_edge_.end(), first_edge_.begin());
  last_.assign(first_.begin(), first_.end() - 1);
  arcs_.resize(2 * count);
  const auto add = [&](int from, int to, std::size_t e) {
    const auto place = static_cast<std::size_t>(last_[from]++);
    arcs_[place] = {to, static_cast<int>(e), lengths_[e]};
  };
  for (std::size_t e = 0; e < count; ++e) {
    add(ends_[e].a, ends_[e].b, e);
    add(ends_[e].b, ends_[e].a, e);
  }
  bucket_width_ = narrow();
}

/// Weights make long arcs so much longer that their mean would put all vertices in few buckets.
double EdgeGraph::narrow() const {
  double shortest = 0, all = 0;
  int count = 0;
  for (const double length : lengths_) all += length;
  for (int v = 0; v < num_vertices(); ++v) {
    double least = std::numeric_limits<double>::infinity();
    for (const Arc& arc : arcs(v)) least = std::min(least, arc.length);
    if (std::isinf(least)) continue;
    shortest += least;
    ++count;
  }
  if (count == 0) return 1;
  return std::max(shortest / count / kBuckets, all / num_edges() / kMostBuckets);
}

int EdgeGraph::edge(int a, int b) const {
  const auto [smaller, larger] = std::minmax(a, b);
  const int end = first_edge_[static_cast<std::size_t>(smaller) + 1];
  for (int e = first_edge_[smaller]; e < end; ++e) {
    if (ends_[e].b == larger) return e;
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
  last_[vertex] = first_[vertex];
}

}  // namespace graspless::geometry
