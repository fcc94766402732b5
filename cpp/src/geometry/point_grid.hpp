// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace graspless::geometry {

/// Points sorted into cubic cells, of which only the occupied ones are stored (a hash table).
class PointGrid {
 public:
  /// The points must be finite and outlive the grid. A cell smaller than 1e-6 of the points' extent
  /// is made larger.
  PointGrid(const Eigen::Matrix3Xd& points, double cell);

  double cell() const { return cell_; }
  int num_cells() const { return static_cast<int>(keys_.size()); }
  /// The points of occupied cell `c` are members()[first(c)] to members()[first(c + 1) - 1].
  int first(int c) const { return first_[static_cast<std::size_t>(c)]; }
  const std::vector<int>& members() const { return members_; }

  /// Calls visit(j) for every point in the 27 cells around point i, itself too: all that are within
  /// a cell's side of it, and others.
  template <typename Visit>
  void near(int i, Visit&& visit) const {
    const std::array<std::int64_t, 3> at = coordinates(i);
    for (std::int64_t x = at[0] - 1; x <= at[0] + 1; ++x) {
      for (std::int64_t y = at[1] - 1; y <= at[1] + 1; ++y) {
        for (std::int64_t z = at[2] - 1; z <= at[2] + 1; ++z) {
          const int c = find(key(x, y, z));
          if (c < 0) continue;
          for (int k = first(c); k < first(c + 1); ++k) {
            visit(members_[static_cast<std::size_t>(k)]);
          }
        }
      }
    }
  }

 private:
  using Key = std::uint64_t;
  static Key key(std::int64_t x, std::int64_t y, std::int64_t z) {
    return (static_cast<Key>(x) << 42) | (static_cast<Key>(y) << 21) | static_cast<Key>(z);
  }
  std::array<std::int64_t, 3> coordinates(int i) const {
    const Eigen::Vector3d at = (points_.col(i) - lower_) / cell_;
    return {static_cast<std::int64_t>(at.x()) + 1, static_cast<std::int64_t>(at.y()) + 1,
            static_cast<std::int64_t>(at.z()) + 1};
  }
  std::size_t slot(Key key) const { return (key * 0x9e3779b97f4a7c15ull) >> shift_; }
  int find(Key key) const;  // the cell, or -1
  int find_or_insert(Key key);

  const Eigen::Matrix3Xd& points_;
  Eigen::Vector3d lower_;
  double cell_;
  int shift_;
  std::vector<int> table_;  // a slot: a cell, or -1
  std::vector<Key> keys_;   // of a cell
  std::vector<int> first_;  // of a cell, in members_; one more at the end
  std::vector<int> members_;
};

}  // namespace graspless::geometry
