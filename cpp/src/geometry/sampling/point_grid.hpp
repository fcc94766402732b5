// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace graspless::geometry {

/// Points sorted into cubic cells. Only occupied cells are stored, in a hash table.
class PointGrid {
 public:
  /// `points`: 3 x n, finite [m]. `cell`: side of a cell [m], increased to 1e-6 of the points'
  /// extent if smaller.
  PointGrid(const Eigen::Matrix3Xd& points, double cell);

  double cell() const { return cell_; }
  int num_cells() const { return static_cast<int>(keys_.size()); }
  /// Range of occupied cell `c` in members(): first(c) to first(c + 1) - 1.
  int first(int c) const { return first_[c]; }
  const std::vector<int>& members() const { return members_; }

  /// Collects the points in the 27 cells around occupied cell `c`, itself included. They include
  /// all points within a cell's side of any point in `c`.
  void points_around(int c, std::vector<int>& points) const;

 private:
  using Key = std::uint64_t;
  Key key_of(const Eigen::Vector3d& point) const;
  std::size_t slot(Key key) const { return (key * 0x9e3779b97f4a7c15ull) >> shift_; }
  int find(Key key) const;  // index of the cell, or -1
  int find_or_insert(Key key);

  Eigen::Vector3d lower_;
  double cell_;
  int shift_;
  std::vector<int> table_;  // per slot: index of a cell, or -1
  std::vector<Key> keys_;   // per cell
  std::vector<int> first_;  // per cell: start in members_; one more entry at the end
  std::vector<int> members_;
};

}  // namespace graspless::geometry
