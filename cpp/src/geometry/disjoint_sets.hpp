// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace graspless::geometry {

/// Disjoint sets of 0 ... n - 1 (union-find).
class DisjointSets {
 public:
  explicit DisjointSets(int n) : parent_(static_cast<std::size_t>(n), -1) {}
  /// Joins two sets. Returns false if they were one set already.
  bool join(int a, int b) {
    int i = root(a), j = root(b);
    if (i == j) return false;
    if (parent(i) > parent(j)) std::swap(i, j);
    parent(i) += parent(j);
    parent(j) = i;
    return true;
  }

  /// Number of elements in the set of one.
  int size(int i) { return -parent(root(i)); }

 private:
  int& parent(int i) { return parent_[static_cast<std::size_t>(i)]; }
  int root(int i) {
    while (parent(i) >= 0) {
      const int above = parent(i);
      if (parent(above) >= 0) parent(i) = parent(above);  // halves the path
      i = above;
    }
    return i;
  }

  std::vector<int> parent_;  // of a root: minus the size of its set
};

}  // namespace graspless::geometry
