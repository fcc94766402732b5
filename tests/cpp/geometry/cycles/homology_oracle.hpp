// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <limits>
#include <map>
#include <vector>

#include "graspless/geometry/complex.hpp"

/// H_1(K; Z_2) the long way: dense matrices, and every vertex as a root.
namespace graspless::geometry {

/// Bit e: edge e of the complex stands in the chain.
using Chain = std::bitset<2048>;

/// A space of chains, by elimination.
class ChainSpace {
 public:
  /// Adds a chain; false where it is in the space already.
  bool add(Chain chain) {
    for (const auto& [lead, row] : rows_) {
      if (chain[lead]) chain ^= row;
    }
    if (chain.none()) return false;
    std::size_t lead = 0;
    while (!chain[lead]) ++lead;
    for (auto& [other, row] : rows_) {
      if (row[lead]) row ^= chain;
    }
    rows_.emplace(lead, chain);
    return true;
  }
  int dimension() const { return static_cast<int>(rows_.size()); }

 private:
  std::map<std::size_t, Chain> rows_;  // by a bit that no other row has
};

class HomologyOracle {
 public:
  explicit HomologyOracle(const Complex& complex) : complex_(complex) {
    for (Eigen::Index e = 0; e < complex.edges.cols(); ++e)
      index_[{complex.edges(0, e), complex.edges(1, e)}] = static_cast<std::size_t>(e);
    for (const auto& t : complex.triangles.colwise())
      boundaries_.add(bit(t[0], t[1]) ^ bit(t[1], t[2]) ^ bit(t[0], t[2]));
  }

  bool has_edge(int a, int b) const { return index_.count({std::min(a, b), std::max(a, b)}) > 0; }
  /// A closed walk as a chain. Throws std::out_of_range where an edge is not there.
  Chain chain(const std::vector<int>& cycle) const {
    Chain sum;
    for (std::size_t i = 0; i < cycle.size(); ++i)
      sum ^= bit(cycle[i], cycle[(i + 1) % cycle.size()]);
    return sum;
  }
  /// The chains that bound.
  const ChainSpace& boundaries() const { return boundaries_; }

  /// Dimension of H_1: edges less the ranks of both boundary matrices.
  int num_classes() const {
    ChainSpace ends;  // columns of the boundary of edges; a vertex a bit
    for (const auto& e : complex_.edges.colwise())
      ends.add(Chain().set(static_cast<std::size_t>(e[0])).set(static_cast<std::size_t>(e[1])));
    return static_cast<int>(complex_.edges.cols()) - ends.dimension() - boundaries_.dimension();
  }

  /// Total length of a shortest basis: all cycles of an edge and the shortest ways from a vertex to
  /// its ends, shortest first, where independent of those before.
  double basis_length() const {
    std::multimap<double, Chain> candidates;
    for (int root = 0; root < complex_.points.cols(); ++root) add_candidates(root, candidates);
    ChainSpace space = boundaries_;
    double total = 0;
    for (const auto& [length, chain] : candidates) {
      if (space.add(chain)) total += length;
    }
    return total;
  }

 private:
  Chain bit(int a, int b) const { return Chain().set(index_.at({std::min(a, b), std::max(a, b)})); }

  double length(const Chain& chain) const {
    double sum = 0;
    for (Eigen::Index e = 0; e < complex_.edges.cols(); ++e) {
      if (chain[e])
        sum +=
            (complex_.points.col(complex_.edges(0, e)) - complex_.points.col(complex_.edges(1, e)))
                .norm();
    }
    return sum;
  }

  void add_candidates(int root, std::multimap<double, Chain>& candidates) const {
    std::map<int, Chain> way{{root, Chain()}};
    std::map<int, double> distance{{root, 0}};
    while (true) {  // Dijkstra's algorithm, every edge looked at every time
      double least = std::numeric_limits<double>::infinity();
      int from = -1, to = -1;
      for (const auto& e : complex_.edges.colwise()) {
        for (const auto& [a, b] : {std::pair(e[0], e[1]), std::pair(e[1], e[0])}) {
          if (!way.count(a) || way.count(b)) continue;
          const double d = distance[a] + (complex_.points.col(a) - complex_.points.col(b)).norm();
          if (d < least) least = d, from = a, to = b;
        }
      }
      if (to < 0) break;
      way[to] = way[from] ^ bit(from, to);
      distance[to] = least;
    }
    for (const auto& e : complex_.edges.colwise()) {
      if (!way.count(e[0])) continue;
      const Chain cycle = way[e[0]] ^ way[e[1]] ^ bit(e[0], e[1]);
      if (cycle.any()) candidates.emplace(length(cycle), cycle);
    }
  }

  const Complex& complex_;
  std::map<std::pair<int, int>, std::size_t> index_;
  ChainSpace boundaries_;
};

}  // namespace graspless::geometry
