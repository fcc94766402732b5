// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An unlimited grid. Cells store distances of their centres, and are cut into 64 on demand.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "graspless/collision/clearance.hpp"

#include "collision/clearance_tree.hpp"

namespace graspless::collision {

/// Distance bounds from a grid of cells. Not thread-safe.
///
/// A cell keeps the triangle that is nearest to its centre, where the searches of its parts begin.
class ClearanceCells {
 public:
  ClearanceCells(std::shared_ptr<const ClearanceTree> tree, double cell);
  ClearanceCells(const ClearanceCells& other);

  double cell() const { return cell_; }
  /// True if the point is near enough to the origin for cells to have numbers there.
  bool covers(const Eigen::Vector3d& point) const {
    return (point.array().abs() < kMostRoots * root_).all();
  }
  /// Returns bounds from the largest cell around the point, which must be covered, that decides on
  /// which side of the threshold the distance lies and, if it is larger, roughly by how much.
  /// Returns the exact distance if no cell decides.
  Clearance::Bounds bounds(const Eigen::Vector3d& point, double threshold) {
    return descend(point, kFinestLevel + 1, [threshold](const auto& bounds, double offset) {
      return bounds.lower - kEnough * offset > threshold || bounds.upper < threshold;
    });
  }
  /// Same, but from a cell of side `cell` if no larger cell decides.
  Clearance::Bounds rough_bounds(const Eigen::Vector3d& point, double threshold) {
    return descend(point, kCellLevel, [threshold](const auto& bounds, double) {
      return bounds.lower > threshold || bounds.upper < threshold;
    });
  }

 private:
  static constexpr int kBits = 2;
  static constexpr int kParts = 1 << kBits;  // per side of a cell
  static constexpr int kCellLevel = 2;       // cell = root / 4^2
  static constexpr int kFinestLevel = 3;
  static constexpr int kFinestParts = 1 << (kBits * kFinestLevel);  // of a root
  static constexpr double kEnough =
      0.3;  // margin beyond the threshold, in units of a cell's uncertainty
  static constexpr double kMostRoots = 1 << 20;
  static constexpr double kRounding = 1e-7;  // relative error of a distance in single precision

  using Number = Eigen::Matrix<std::int64_t, 3, 1>;

  struct Cell {
    float distance = -1;  // of the centre; negative: not computed yet
    int triangle = 0;     // nearest to the centre
    int parts = -1;       // index in blocks_; negative: not subdivided
  };
  using Block = std::array<Cell, kParts * kParts * kParts>;
  struct Slot {
    std::uint64_t key;
    int root;  // index in roots_; -1 in a free slot
  };

  template <typename Settled>
  Clearance::Bounds descend(const Eigen::Vector3d& point, int last_level, Settled settled);
  Cell& root(const Number& number) {
    const auto key = static_cast<std::uint64_t>(number.x() << 42 | number.y() << 21 | number.z());
    if (last_root_ >= 0 && key == last_key_) return roots_[last_root_];
    return other_root(key);
  }
  Cell& other_root(std::uint64_t key);
  std::size_t find(std::uint64_t key) const;
  void clear();
  void grow();

  std::shared_ptr<const ClearanceTree> tree_;
  double cell_, root_, per_root_;
  std::vector<Slot> slots_;  // a power of two, at most half full
  int shift_ = 0;
  std::vector<Cell> roots_;
  std::vector<std::unique_ptr<Block>> blocks_;
  std::uint64_t last_key_ = 0;
  int last_root_ = -1;
};

template <typename Settled>
Clearance::Bounds ClearanceCells::descend(const Eigen::Vector3d& point, int last_level,
                                          Settled settled) {
  // Truncation equals the floor for positive numbers, and takes a single instruction.
  const Eigen::Vector3d scaled = (point * per_root_).array() + kMostRoots;
  // Position in parts of the finest level: from its bits follow those of all levels.
  const Number finest = (scaled * kFinestParts).cast<std::int64_t>();
  const auto at_level = [&finest](int axis, int level) {
    return finest[axis] >> (kBits * (kFinestLevel - level));
  };
  Cell* cell = &root({at_level(0, 0), at_level(1, 0), at_level(2, 0)});
  double side = root_, parts = 1;  // of a cell, and in a root
  int hint = cell->triangle;
  for (int level = 0;; ++level, side /= kParts, parts *= kParts) {
    const Number number(at_level(0, level), at_level(1, level), at_level(2, level));
    const Eigen::Vector3d from_middle =
        side * ((parts * scaled - number.cast<double>()).array() - 0.5).matrix();
    if (level > 0) {
      constexpr int kMask = kParts - 1;
      const auto index =
          ((number.x() & kMask) * kParts + (number.y() & kMask)) * kParts + (number.z() & kMask);
      cell = &(*blocks_[cell->parts])[index];
    }
    if (cell->distance < 0) {
      const NearTriangle near = tree_->nearest(point - from_middle, hint);
      cell->distance = static_cast<float>(std::sqrt(near.squared));
      cell->triangle = near.triangle;
    }
    const auto distance = static_cast<double>(cell->distance);
    const double offset = from_middle.norm() + kRounding * distance;
    const Clearance::Bounds bounds{std::max(0.0, distance - offset), distance + offset};
    if (level == last_level || settled(bounds, offset)) return bounds;
    hint = cell->triangle;
    if (level == kFinestLevel) {
      const double exact = std::sqrt(tree_->nearest(point, hint).squared);
      return {exact, exact};
    }
    if (cell->parts < 0) {
      blocks_.push_back(std::make_unique<Block>());
      cell->parts = static_cast<int>(blocks_.size()) - 1;
    }
  }
}

}  // namespace graspless::collision
