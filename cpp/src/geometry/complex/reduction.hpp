// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/complex/ranking.hpp"

namespace graspless::geometry {

/// The reduced boundary matrix of the triangles over Z_2: which triangle fills what which edge
/// began. Only triangles that fill a loop have a column.
class Reduction {
 public:
  explicit Reduction(Ranking ranking);

  const Ranking& ranking() const { return ranking_; }
  /// Longest ratio first; pairs that die at birth are left out.
  const std::vector<PersistencePair>& pairs() const { return pairs_; }
  /// From when to when the class in K_d of a cycle (ranks of its edges) lives.
  PersistencePair span(const std::vector<int>& cycle, double max_edge_length) const;

 private:
  struct Column {
    int triangle = -1;
    int begin = 0, end = 0;  // of entries_
  };
  struct Remainder {
    int pivot;          // -1: nothing is left
    int last_triangle;  // of the columns added
  };
  Remainder reduce(std::vector<int>& heap, int end_triangle) const;
  void add_column(int triangle);
  void collect_pairs();

  Ranking ranking_;
  std::vector<Column> columns_;  // by pivot, the longest edge of the column
  std::vector<int> entries_;     // of the columns, without the pivots
  std::vector<PersistencePair> pairs_;
};

}  // namespace graspless::geometry
