// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "geometry/loops/annotation.hpp"
#include "geometry/loops/shortest_basis.hpp"

namespace graspless::geometry {

/// The shortest independent cycles of those offered so far, at most one a dimension of H_1.
class CycleBasis {
 public:
  explicit CycleBasis(const Annotation& annotation)
      : num_classes_(annotation.num_classes()), words_(annotation.words()) {}

  /// A cycle must be shorter than this to have a place [m].
  double bound() const {
    return size() < num_classes_ ? std::numeric_limits<double>::infinity() : members_.back().length;
  }
  /// Whether a cycle of this class and length would have a place.
  bool has_place(const Annotation::Word* cls, double length) const;
  /// Length of the longest member that a class is made of: a cycle of this class must be shorter to
  /// have a place [m].
  double bound(const Annotation::Word* cls) const;
  /// Gives it that place, which may cost a longer one its own.
  void offer(const Annotation::Word* cls, double length, Cycle cycle);

  int size() const { return static_cast<int>(members_.size()); }
  std::vector<Cycle> cycles() const;  ///< shortest first

 private:
  using Word = Annotation::Word;
  struct Member {
    double length;
    std::vector<Word> cls;
    Cycle cycle;
  };
  /// A class less what the first members make of it; its highest bit is no other row's.
  struct Row {
    std::vector<Word> bits;
    int lead;
  };
  int lead(const std::vector<Word>& cls) const;
  bool depends(std::vector<Word>& cls, std::size_t count) const;
  void make_rows(std::size_t first);

  int num_classes_, words_;
  std::vector<Member> members_;  // shortest first
  std::vector<Row> rows_;        // row i: member i, reduced by the rows before it
  mutable std::vector<Word> scratch_;
};

}  // namespace graspless::geometry
