// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A grid without end that holds a distance at the middle of every cell asked about.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "collision/clearance_tree.hpp"

namespace graspless::collision {

/// Cubes of cells, found by hashing. Not shared between threads.
class ClearanceCells {
 public:
  explicit ClearanceCells(double cell);

  /// Whether the point is so near to the origin that cells are numbered there.
  bool covers(const Eigen::Vector3d& point) const { return (point.array().abs() < reach_).all(); }
  /// The distance at the middle of the point's cell, too small by no more than rounding to single
  /// precision, and how far off the middle is [m]. The point must be covered.
  struct Sample {
    float distance;
    double offset;
  };
  Sample sample(const Eigen::Vector3d& point, const ClearanceTree& tree, Eigen::Vector3d& near) {
    const Eigen::Vector3d scaled = point * per_cell_;
    // Truncation of a positive number is its floor, and cheaper.
    const std::int64_t x = static_cast<std::int64_t>(scaled.x() + kBias) - kBias;
    const std::int64_t y = static_cast<std::int64_t>(scaled.y() + kBias) - kBias;
    const std::int64_t z = static_cast<std::int64_t>(scaled.z() + kBias) - kBias;
    const Eigen::Vector3d middle(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5,
                                 static_cast<double>(z) + 0.5);
    float& value = block(x >> 3, y >> 3, z >> 3)[((x & 7) << 6) | ((y & 7) << 3) | (z & 7)];
    if (value < 0) value = static_cast<float>(tree.distance(middle * cell_, near));
    return {value, (scaled - middle).norm() * cell_};
  }

 private:
  static constexpr std::int64_t kBias = std::int64_t{1} << 20;  // cells each way
  static constexpr std::size_t kBlock = 512;                    // 8 x 8 x 8 cells

  struct Slot {
    std::uint64_t key;
    float* values;  // null in a free slot
  };

  float* block(std::int64_t x, std::int64_t y, std::int64_t z) {
    const std::uint64_t key = (static_cast<std::uint64_t>(x + kBias) << 42) |
                              (static_cast<std::uint64_t>(y + kBias) << 21) |
                              static_cast<std::uint64_t>(z + kBias);
    if (key == last_key_) return last_;
    for (std::size_t i = place(key);; i = (i + 1) & (slots_.size() - 1)) {
      if (slots_[i].values == nullptr) return add(key);
      if (slots_[i].key != key) continue;
      last_key_ = key;
      return last_ = slots_[i].values;
    }
  }
  std::size_t place(std::uint64_t key) const {
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> shift_);
  }
  float* add(std::uint64_t key);
  void clear();
  void grow();

  double cell_, per_cell_, reach_;
  std::vector<Slot> slots_;  // a power of two, at most half full
  int shift_;
  std::vector<std::unique_ptr<float[]>> blocks_;
  std::uint64_t last_key_ = ~std::uint64_t{0};
  float* last_ = nullptr;
};

}  // namespace graspless::collision
