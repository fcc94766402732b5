// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/point_grid.hpp"

#include <algorithm>

namespace graspless::geometry {
namespace {

// A coordinate is 21 bits of a key, with room for neighbours at both ends.
constexpr double kMaxCellsPerAxis = 1e6;

}  // namespace

PointGrid::PointGrid(const Eigen::Matrix3Xd& points, double cell)
    : points_(points), lower_(Eigen::Vector3d::Zero()), cell_(cell), shift_(60) {
  const int n = static_cast<int>(points.cols());
  if (n > 0) {
    lower_ = points.rowwise().minCoeff();
    const double extent = (points.rowwise().maxCoeff() - lower_).maxCoeff();
    cell_ = std::max(cell, extent / kMaxCellsPerAxis);
  }
  while ((std::size_t{1} << (64 - shift_)) < 2 * static_cast<std::size_t>(n)) --shift_;
  table_.assign(std::size_t{1} << (64 - shift_), -1);

  std::vector<int> cell_of(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const auto at = coordinates(i);
    const int c = find_or_insert(key(at[0], at[1], at[2]));
    cell_of[static_cast<std::size_t>(i)] = c;
    ++first_[static_cast<std::size_t>(c)];
  }
  int sum = 0;
  for (int& first : first_) {
    sum += first;
    first = sum;
  }
  first_.push_back(n);
  members_.resize(static_cast<std::size_t>(n));
  for (int i = n - 1; i >= 0; --i) {
    int& first = first_[static_cast<std::size_t>(cell_of[static_cast<std::size_t>(i)])];
    members_[static_cast<std::size_t>(--first)] = i;
  }
}

int PointGrid::find(Key key) const {
  for (std::size_t s = slot(key);; s = (s + 1) % table_.size()) {
    const int c = table_[s];
    if (c < 0 || keys_[static_cast<std::size_t>(c)] == key) return c;
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
    if (keys_[static_cast<std::size_t>(table_[s])] == key) return table_[s];
  }
}

}  // namespace graspless::geometry
