// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/complex/simplices.hpp"

#include <algorithm>
#include <utility>

#include "geometry/pulse.hpp"

namespace graspless::geometry {
namespace {

using Facet = Delaunay::Facet;

/// Index of the first item of each bucket (exclusive prefix sum).
std::vector<int> starts(std::vector<int> counts) {
  int sum = 0;
  for (int& count : counts) sum += std::exchange(count, sum);
  return counts;
}

/// Sorts lexicographically: buckets by the first vertex, then each bucket.
std::vector<Facet> sorted(const std::vector<Facet>& facets, std::size_t n) {
  std::vector<int> counts(n + 1);
  for (const Facet& facet : facets) ++counts[facet.vertices[0]];
  const std::vector<int> begin = starts(std::move(counts));
  std::vector<int> next = begin;
  std::vector<Facet> result(facets.size());
  Pulse pulse;
  for (const Facet& facet : facets) {
    pulse();
    int& place = next[facet.vertices[0]];
    result[place++] = facet;
  }
  for (std::size_t a = 0; a < n; ++a) {
    pulse();
    std::sort(result.begin() + begin[a], result.begin() + begin[a + 1],
              [](const Facet& one, const Facet& other) { return one.vertices < other.vertices; });
  }
  return result;
}

/// Collects the edges of all triangles, which are all edges: buckets by the smaller vertex, each
/// sorted without duplicates.
void collect_edges(const std::vector<Facet>& facets, std::size_t n, Simplices& out) {
  std::vector<int> counts(n + 1);
  Pulse pulse;
  for (const Facet& facet : facets) {
    pulse();
    counts[facet.vertices[0]] += 2;
    counts[facet.vertices[1]] += 1;
  }
  const std::vector<int> begin = starts(std::move(counts));
  std::vector<int> next = begin, larger(3 * facets.size());
  const auto put = [&](int a, int b) { larger[next[a]++] = b; };
  for (const Facet& facet : facets) {
    pulse();
    const auto [a, b, c] = facet.vertices;
    put(a, b);
    put(a, c);
    put(b, c);
  }
  out.first_edge.assign(n + 1, 0);
  std::vector<int> last_end_of(n, -1);  // the other end of each vertex's latest edge
  for (std::size_t a = 0; a < n; ++a) {
    pulse();
    const auto first = larger.begin() + begin[a];
    const auto end = std::remove_if(first, larger.begin() + begin[a + 1], [&](int b) {
      return std::exchange(last_end_of[b], static_cast<int>(a)) == static_cast<int>(a);
    });
    std::sort(first, end);
    for (auto b = first; b != end; ++b) out.edges.push_back({static_cast<int>(a), *b});
    out.first_edge[a + 1] = static_cast<int>(out.edges.size());
  }
}

}  // namespace

int Simplices::edge(int a, int b) const {
  if (a > b) std::swap(a, b);
  const auto begin = edges.begin() + first_edge[a];
  const auto end = edges.begin() + first_edge[static_cast<std::size_t>(a) + 1];
  const auto found = std::lower_bound(begin, end, b, [](const auto& e, int v) { return e[1] < v; });
  return found != end && (*found)[1] == b ? static_cast<int>(found - edges.begin()) : -1;
}

Simplices simplices(const Eigen::Matrix3Xd& points, const Delaunay& delaunay) {
  const auto n = static_cast<std::size_t>(points.cols());
  const std::vector<Facet> facets = sorted(delaunay.facets, n);

  Simplices result;
  result.num_vertices = delaunay.num_vertices;
  result.num_regions = delaunay.num_regions;
  result.edges.reserve(facets.size());
  collect_edges(facets, n, result);
  result.lengths.reserve(result.edges.size());
  Pulse pulse;
  for (const auto& [a, b] : result.edges) {
    pulse();
    result.lengths.push_back((points.col(a) - points.col(b)).norm());
  }
  result.triangles.reserve(facets.size());
  std::vector<int> edge_to(n);  // from the first vertex
  int first = -1;
  for (const Facet& facet : facets) {
    pulse();
    const auto [a, b, c] = facet.vertices;
    if (a != first) {
      first = a;
      const int end = result.first_edge[static_cast<std::size_t>(a) + 1];
      for (int e = result.first_edge[a]; e < end; ++e) edge_to[result.edges[e][1]] = e;
    }
    const std::array<int, 3> edges{edge_to[b], edge_to[c], result.edge(b, c)};
    double longest = 0;
    for (const int e : edges) {
      longest = std::max(longest, result.lengths[e]);
    }
    result.triangles.push_back({facet.vertices, edges, facet.regions, longest});
  }
  return result;
}

}  // namespace graspless::geometry
