// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace graspless::geometry {

/// Points sorted into cubic cells, of which only the occupied ones are stored (a hash table).
class PointGrid {
 public:
  /// The points must be finite. A cell smaller than 1e-6 of the points' extent
  /// is made larger.
  PointGrid(const Eigen::Matrix3Xd& points, double cell);

  double cell() const { return cell_; }
  int num_cells() const { return static_cast<int>(keys_.size()); }
  /// The points of occupied cell `c` are members()[first(c)] to members()[first(c + 1) - 1].
  int first(int c) const { return first_[static_cast<std::size_t>(c)]; }
  const std::vector<int>& members() const { return members_; }

  /// The points in the 27 cells around occupied cell `c`, its own too: all that are within a cell's
  /// side of any point of it, and others.
  void points_around(int c, std::vector<int>& points) const;

 private:
  using Key = std::uint64_t;
  Key key_of(const Eigen::Vector3d& point) const;
  std::size_t slot(Key key) const { return (key * 0x9e3779b97f4a7c15ull) >> shift_; }
  int find(Key key) const;  // the cell, or -1
  int find_or_insert(Key key);

  Eigen::Vector3d lower_;
  double cell_;
  int shift_;
  std::vector<int> table_;  // a slot: a cell, or -1
  std::vector<Key> keys_;   // of a cell
  std::vector<int> first_;  // of a cell, in members_; one more at the end
  std::vector<int> members_;
};

}  // namespace graspless::geometry
