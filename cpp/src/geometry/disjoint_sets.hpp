// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

namespace graspless::geometry {

/// Disjoint sets of 0 ... n - 1 (union-find).
class DisjointSets {
 public:
  explicit DisjointSets(int n) : parent_(n, -1) {}
  /// Joins two sets. Returns false if they were one set already.
  bool join(int a, int b) {
    int i = root(a), j = root(b);
    if (i == j) return false;
    if (parent_[i] > parent_[j]) std::swap(i, j);
    parent_[i] += parent_[j];
    parent_[j] = i;
    return true;
  }

  /// Number of elements in the set of one.
  int size(int i) { return -parent_[root(i)]; }

  /// Element that stands for the set of one.
  int root(int i) {
    while (parent_[i] >= 0) {
      const int above = parent_[i];
      if (parent_[above] >= 0) parent_[i] = parent_[above];  // halves the path
      i = above;
    }
    return i;
  }

 private:
  std::vector<int> parent_;  // of a root: minus the size of its set
};

}  // namespace graspless::geometry
