// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sampling/darts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "graspless/watch.hpp"

namespace graspless::geometry {
namespace {

using Eigen::Vector3d;

constexpr int kCoarse = 64;         // cells along an axis of in_cell_order()
constexpr double kDistance = 0.69;  // between points, over the root of the area of one
constexpr double kShrink = 0.97;    // of the distance, beside its due, if too few are kept
constexpr int kRounds = 20;         // after which equal points are kept, too
constexpr double kMaxDartCells = 1e6;

/// Points no two of which are nearer to each other than `distance`.
class Darts {
 public:
  Darts(const Vector3d& lower, double extent, double distance, int most)
      : lower_(lower), distance_(distance), side_(std::max(2 * distance, extent / kMaxDartCells)) {
    std::size_t size = 1024;
    while (2 * size < 3 * static_cast<std::size_t>(most)) size *= 2;  // never full
    slots_.resize(size);
  }

  /// Keeps p unless a point kept before is too near.
  bool add(const Vector3d& p) {
    const Vector3d at = (p - lower_) / side_ + Vector3d::Ones();
    // The ball of `distance` about p meets two cells of twice that side along an axis.
    const auto corner = (at.array() - 0.5).cast<std::uint64_t>().eval();
    for (std::uint64_t k = 0; k < 8; ++k) {
      const Slot& slot =
          slots_[find(key(corner[0] + k / 4, corner[1] + k / 2 % 2, corner[2] + k % 2))];
      for (int i = slot.first; i >= 0; i = next_[i]) {
        if ((points_[i] - p).squaredNorm() < distance_ * distance_) return false;
      }
    }
    insert(p, key(static_cast<std::uint64_t>(at[0]), static_cast<std::uint64_t>(at[1]),
                  static_cast<std::uint64_t>(at[2])));
    return true;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    int first = -1;  // point in the cell; -1: the slot is free
  };
  static std::uint64_t key(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    return (x << 42) + (y << 21) + z;
  }
  /// Slot of a cell, or the free one where it belongs. Cells above each other are neighbours.
  std::size_t find(std::uint64_t key) const {
    const std::uint64_t z = key & ((1u << 21) - 1);
    std::size_t s = ((key >> 21) * 0x9e3779b97f4a7c15ull >> 32) + z;
    for (s &= slots_.size() - 1; slots_[s].first >= 0 && slots_[s].key != key;)
      s = (s + 1) & (slots_.size() - 1);
    return s;
  }
  void insert(const Vector3d& p, std::uint64_t key) {
    Slot& slot = slots_[find(key)];
    next_.push_back(slot.first);
    slot = {key, static_cast<int>(points_.size())};
    points_.push_back(p);
  }

  Vector3d lower_;
  double distance_, side_;
  std::vector<Slot> slots_;
  std::vector<Vector3d> points_;
  std::vector<int> next_;  // in the same cell
};

}  // namespace

Eigen::Matrix3Xd in_cell_order(const Eigen::Matrix3Xd& points) {
  const Vector3d lower = points.rowwise().minCoeff();
  const double extent = (points.rowwise().maxCoeff() - lower).maxCoeff();
  const double scale = extent > 0 ? kCoarse * (1 - 1e-9) / extent : 0;
  std::vector<int> first(kCoarse * kCoarse * kCoarse + 1, 0);
  std::vector<int> cells(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3i at = ((points.col(i) - lower) * scale).cast<int>();
    const int cell = (at.x() * kCoarse + at.y()) * kCoarse + at.z();
    cells[i] = cell;
    ++first[static_cast<std::size_t>(cell) + 1];
  }
  for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
  Eigen::Matrix3Xd sorted(3, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const auto cell = static_cast<std::size_t>(cells[i]);
    sorted.col(first[cell]++) = points.col(i);
  }
  return sorted;
}

std::vector<int> throw_darts(const Eigen::Matrix3Xd& points, int count, double area) {
  const Vector3d lower = points.rowwise().minCoeff();
  const double extent = (points.rowwise().maxCoeff() - lower).maxCoeff();
  double distance = kDistance * std::sqrt(area / count);
  std::vector<int> kept;
  for (int round = 0;; ++round) {
    kept.clear();
    Darts darts(lower, extent, round < kRounds ? distance : 0, static_cast<int>(points.cols()));
    for (int i = 0; i < points.cols(); ++i) {
      poll();
      if (darts.add(points.col(i))) kept.push_back(i);
    }
    if (kept.size() >= static_cast<std::size_t>(count)) break;
    distance *= kShrink * std::sqrt(static_cast<double>(kept.size()) / count);
  }
  const auto all = static_cast<std::int64_t>(kept.size());
  for (std::int64_t k = 0; k < count; ++k)  // drops what is too many, everywhere as much
    kept[k] = kept[k * all / count];
  kept.resize(count);
  return kept;
}

}  // namespace graspless::geometry
