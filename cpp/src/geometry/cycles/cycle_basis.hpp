// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "geometry/cycles/annotation.hpp"
#include "geometry/cycles/shortest_basis.hpp"

namespace graspless::geometry {

/// The shortest independent cycles among those offered so far, at most one per dimension of H_1.
class CycleBasis {
 public:
  explicit CycleBasis(const Annotation& annotation)
      : num_classes_(annotation.num_classes()), words_(annotation.words()) {}

  /// Upper bound on the length of a cycle that can still enter the basis [m].
  double bound() const {
    return size() < num_classes_ ? std::numeric_limits<double>::infinity() : members_.back().length;
  }
  /// True if a cycle of this class and length would enter the basis.
  bool would_improve(const Annotation::Word* cls, double length) const;
  /// Same for a cycle of a given class: the length of the longest member in the representation of
  /// the class [m].
  double bound(const Annotation::Word* cls) const;
  /// Adds the cycle if it improves the basis. A longer member may be removed.
  void offer(const Annotation::Word* cls, double length, Cycle cycle);

  int size() const { return static_cast<int>(members_.size()); }
  std::vector<ClassCycle> cycles() const;  ///< shortest first

 private:
  using Word = Annotation::Word;
  struct Member {
    double length;
    std::vector<Word> cls;
    Cycle cycle;
  };
  /// A class reduced by the rows before it, with its highest bit. No other row has the same one.
  struct Row {
    std::vector<Word> bits;
    int lead;
  };
  int lead(const std::vector<Word>& cls) const;
  bool depends(std::vector<Word>& cls, std::size_t count) const;
  void make_rows(std::size_t first);

  int num_classes_, words_;
  std::vector<Member> members_;        // shortest first
  std::vector<Row> rows_;              // row i: member i, reduced by the rows before it
  mutable std::vector<Word> scratch_;  // avoids allocations
};

}  // namespace graspless::geometry
