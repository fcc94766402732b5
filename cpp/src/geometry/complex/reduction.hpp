// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/complex/ranking.hpp"

namespace graspless::geometry {

/// Reduced boundary matrix of the triangles over Z_2. It pairs each triangle that fills a loop with
/// the edge that created the loop. Other triangles have no column.
class Reduction {
 public:
  explicit Reduction(Ranking ranking);

  const Ranking& ranking() const { return ranking_; }
  /// Persistence pairs, largest ratio death / birth first. Omits pairs that die at birth.
  const std::vector<PersistencePair>& pairs() const { return pairs_; }
  /// Labels by rank of the edges shorter than `max_edge_length`; classes are indices of pairs().
  std::vector<std::uint64_t> labels(double max_edge_length, const std::vector<int>& classes,
                                    int words) const;
  /// Edge, by rank, that closes the loop of a pair, and index in Simplices of the triangle that
  /// fills it.
  struct Ends {
    int edge, triangle;
  };
  Ends ends(int pair) const;
  /// Birth and death of the class of a cycle in K_d, given by the ranks of its edges.
  PersistencePair span(const std::vector<int>& cycle, double max_edge_length) const;

 private:
  struct Column {
    int triangle = -1;
    int begin = 0, end = 0;  // range in entries_
  };
  struct Remainder {
    int pivot;          // longest edge left, or -1
    int last_triangle;  // largest triangle of the columns added, or -1
  };
  Remainder reduce(std::vector<int>& heap, int end_triangle) const;
  void add_column(int triangle);
  void collect_pairs();

  Ranking ranking_;
  std::vector<Column> columns_;  // by pivot: the longest edge of the column
  std::vector<int> entries_;     // other edges of the columns
  std::vector<PersistencePair> pairs_;
  std::vector<int> pivots_;  // of the pairs
};

}  // namespace graspless::geometry
