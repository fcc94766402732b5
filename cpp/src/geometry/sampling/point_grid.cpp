// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sampling/point_grid.hpp"

#include <algorithm>

#include "geometry/pulse.hpp"

namespace graspless::geometry {
namespace {

// A key has 21 bits per coordinate. This leaves room for neighbours at both ends.
constexpr double kMaxCellsPerAxis = 1e6;

// Differences between the keys of neighbours.
constexpr std::uint64_t kAlongX = std::uint64_t{1} << 42, kAlongY = std::uint64_t{1} << 21;

}  // namespace

PointGrid::PointGrid(const Eigen::Matrix3Xd& points, double cell)
    : lower_(Eigen::Vector3d::Zero()), cell_(cell), shift_(60) {
  const int n = static_cast<int>(points.cols());
  if (n > 0) {
    lower_ = points.rowwise().minCoeff();
    const double extent = (points.rowwise().maxCoeff() - lower_).maxCoeff();
    cell_ = std::max(cell, extent / kMaxCellsPerAxis);
  }
  while ((std::size_t{1} << (64 - shift_)) < 2 * static_cast<std::size_t>(n)) --shift_;
  table_.assign(std::size_t{1} << (64 - shift_), -1);

  std::vector<int> cell_of(n);
  Pulse pulse;
  for (int i = 0; i < n; ++i) {
    pulse();
    const int c = find_or_insert(key_of(points.col(i)));
    cell_of[i] = c;
    ++first_[c];
  }
  int sum = 0;
  for (int& first : first_) {
    sum += first;
    first = sum;
  }
  first_.push_back(n);
  members_.resize(n);
  for (int i = n - 1; i >= 0; --i) {
    int& first = first_[cell_of[i]];
    members_[--first] = i;
  }
}

void PointGrid::points_around(int c, std::vector<int>& points) const {
  points.clear();
  const Key middle = keys_[c];
  for (int neighbour = 0; neighbour < 27; ++neighbour) {
    const Key x = static_cast<Key>(neighbour / 9), y = static_cast<Key>(neighbour / 3 % 3),
              z = static_cast<Key>(neighbour % 3);
    const int found = find(middle - kAlongX - kAlongY - 1 + x * kAlongX + y * kAlongY + z);
    if (found < 0) continue;
    points.insert(points.end(), members_.begin() + first(found),
                  members_.begin() + first(found + 1));
  }
}

// Coordinates start at 1, so that neighbours at the lower end have a key too.
PointGrid::Key PointGrid::key_of(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d at = (point - lower_) / cell_ + Eigen::Vector3d::Ones();
  return static_cast<Key>(at.x()) * kAlongX + static_cast<Key>(at.y()) * kAlongY +
         static_cast<Key>(at.z());
}

int PointGrid::find(Key key) const {
  for (std::size_t s = slot(key);; s = (s + 1) % table_.size()) {
    const int c = table_[s];
    if (c < 0 || keys_[c] == key) return c;
  }
}

int PointGrid::find_or_insert(Key key) {
  for (std::size_t s = slot(key);; s = (s + 1) % table_.size()) {
    if (table_[s] < 0) {
      table_[s] = num_cells();
      keys_.push_back(key);
      first_.push_back(0);
      return table_[s];
    }
    if (keys_[table_[s]] == key) return table_[s];
  }
}

}  // namespace graspless::geometry
