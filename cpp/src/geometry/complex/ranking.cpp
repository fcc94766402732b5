// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/complex/ranking.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "geometry/ascending.hpp"
#include "geometry/disjoint_sets.hpp"
#include "geometry/pulse.hpp"

namespace graspless::geometry {
namespace {

/// Indices of triangles sorted by the rank of their longest edge, stable.
std::vector<int> by_longest(const std::vector<Ranking::Triangle>& triangles, std::size_t n) {
  std::vector<int> next(n + 1);
  for (const auto& triangle : triangles) ++next[static_cast<std::size_t>(triangle.longest) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<int> order(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    int& place = next[triangles[i].longest];
    order[place++] = static_cast<int>(i);
  }
  return order;
}

/// By Alexander duality, a triangle encloses a new void, and fills no loop, exactly if it separates
/// a connected part of the complement. In reverse order, such a triangle joins two sets of regions.
void mark_fillings(const Simplices& simplices, const std::vector<int>& order, Ranking& out) {
  DisjointSets regions(simplices.num_regions);
  Pulse pulse;
  for (std::size_t i = order.size(); i-- > 0;) {
    pulse();
    const auto [one, other] = simplices.triangles[order[i]].regions;
    out.triangles[i].fills_loop = !regions.join(one, other);
  }
}

}  // namespace

Ranking ranking(const Simplices& simplices) {
  Ranking result;
  const std::vector<int> order = ascending(simplices.lengths);  // edges
  result.rank.resize(order.size());
  result.lengths.reserve(order.size());
  result.makes_loop.reserve(order.size());
  result.edge = order;
  DisjointSets pieces(static_cast<int>(simplices.first_edge.size()));
  Pulse pulse;
  for (const int edge : order) {
    pulse();
    const auto e = static_cast<std::size_t>(edge);
    result.rank[e] = static_cast<int>(result.lengths.size());
    result.lengths.push_back(simplices.lengths[e]);
    result.makes_loop.push_back(!pieces.join(simplices.edges[e][0], simplices.edges[e][1]));
  }

  std::vector<Ranking::Triangle> triangles;
  triangles.reserve(simplices.triangles.size());
  for (const auto& triangle : simplices.triangles) {
    pulse();
    std::array<int, 3> r{};
    for (std::size_t k : {0u, 1u, 2u}) {
      r[k] = result.rank[triangle.edges[k]];
    }
    const auto longest = std::max_element(r.begin(), r.end());
    std::iter_swap(longest, r.end() - 1);
    triangles.push_back({r[2], {r[0], r[1]}, false, static_cast<int>(triangles.size())});
  }
  const std::vector<int> entering = by_longest(triangles, order.size());
  result.triangles.reserve(triangles.size());
  for (const int i : entering) result.triangles.push_back(triangles[i]);
  mark_fillings(simplices, entering, result);
  return result;
}

BettiCurve betti_curve(const Ranking& ranking) {
  BettiCurve curve;
  int loops = 0;
  std::size_t t = 0;
  Pulse pulse;
  for (std::size_t e = 0; e < ranking.lengths.size(); ++e) {
    pulse();
    loops += ranking.makes_loop[e];
    for (; t < ranking.triangles.size() && ranking.triangles[t].longest == static_cast<int>(e);
         ++t) {
      loops -= ranking.triangles[t].fills_loop;
    }
    if (e + 1 < ranking.lengths.size() && ranking.lengths[e + 1] == ranking.lengths[e]) continue;
    if (loops == (curve.loops.empty() ? 0 : curve.loops.back())) continue;
    curve.max_edge_length.push_back(ranking.lengths[e]);
    curve.loops.push_back(loops);
  }
  return curve;
}

}  // namespace graspless::geometry
