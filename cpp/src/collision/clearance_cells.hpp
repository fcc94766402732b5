// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A grid without end, each of whose cells is cut into 64 where that is asked for, and knows the
// distance of its middle from a surface.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "graspless/collision/clearance.hpp"

#include "collision/clearance_triangles.hpp"

namespace graspless::collision {

/// Not shared between threads.
///
/// A cell that is cut keeps the triangles that are nearest to any of its points, and its parts look
/// at no others: the smaller a cell, the cheaper its distance.
class ClearanceCells {
 public:
  using Triangles = std::vector<SurfaceTriangle>;

  ClearanceCells(std::shared_ptr<const Triangles> triangles, double cell);

  double cell() const { return cell_; }
  /// Whether the point is so near to the origin that cells are numbered there.
  bool covers(const Eigen::Vector3d& point) const {
    return (point.array().abs() < kMostRoots * root_).all();
  }
  /// Bounds from the cell of side `cell` around the point, which must be covered.
  Clearance::Bounds bounds(const Eigen::Vector3d& point) {
    return descend(point, kCellLevel, [](const auto&, double) { return false; });
  }
  /// Bounds from the largest cell that settles on which side of the threshold the distance lies,
  /// and if it is more, about how much; the distance itself where none does.
  Clearance::Bounds bounds(const Eigen::Vector3d& point, double threshold) {
    return descend(point, kFinestLevel + 1, [threshold](const auto& bounds, double offset) {
      return bounds.lower - kEnough * offset > threshold || bounds.upper < threshold;
    });
  }
  /// The same, from a cell of side `cell` where no larger one settles it.
  Clearance::Bounds rough_bounds(const Eigen::Vector3d& point, double threshold) {
    return descend(point, kCellLevel, [threshold](const auto& bounds, double) {
      return bounds.lower > threshold || bounds.upper < threshold;
    });
  }

 private:
  static constexpr int kParts = 4;      // of a cell's side
  static constexpr int kCellLevel = 3;  // cell = root / 4^3
  static constexpr int kFinestLevel = 4;
  static constexpr double kEnough = 0.3;  // of a cell's uncertainty, beyond a threshold it settles
  static constexpr double kMostRoots = 1 << 20;
  static constexpr double kRounding = 1e-7;  // of a distance in single precision
  // Of a cube of side 1: half its diagonal, and how far its middle is at most from that of the cube
  // of which it is a part.
  static constexpr double kHalfDiagonal = 0.8660254037844387;
  static constexpr double kMostOffset = (kParts - 1) * kHalfDiagonal;

  using Number = Eigen::Matrix<std::int64_t, 3, 1>;

  struct Cell {
    float distance = -1;  // of the middle; negative: not yet known
    int parts = -1;       // in blocks_
  };
  struct Near {
    float distance;  // of the triangle from the middle of the cell that was cut, at least
    int triangle;
  };
  using List = std::vector<Near>;
  struct Block {
    std::array<Cell, kParts * kParts * kParts> cells;
    List nearest;  // the triangles to look at, the nearest first
  };
  struct Slot {
    std::uint64_t key;
    int root;  // in roots_; -1 in a free slot
  };

  template <typename Settled>
  Clearance::Bounds descend(const Eigen::Vector3d& point, int last_level, Settled settled);
  Cell& root(const Number& number);
  std::size_t find(std::uint64_t key) const;
  double measure(const Eigen::Vector3d& point, double offset, const List& nearest) const;
  int cut(const Cell& cell, const Eigen::Vector3d& middle, double side, const List& nearest);
  void clear();
  void grow();

  std::shared_ptr<const Triangles> triangles_;
  List all_;  // the triangles of a root
  double cell_, root_, per_root_;
  std::vector<Slot> slots_;  // a power of two, at most half full
  int shift_ = 0;
  std::vector<Cell> roots_;
  std::vector<std::unique_ptr<Block>> blocks_;
  std::size_t listed_ = 0;  // triangles, in all blocks
  std::uint64_t last_key_ = 0;
  int last_root_ = -1;
};

template <typename Settled>
Clearance::Bounds ClearanceCells::descend(const Eigen::Vector3d& point, int last_level,
                                          Settled settled) {
  // Truncation is the floor of a positive number, and a single instruction.
  const Eigen::Vector3d scaled = (point * per_root_).array() + kMostRoots;
  const Number number = scaled.cast<std::int64_t>();
  Eigen::Vector3d within = scaled - number.cast<double>();  // of the cell, in [0, 1)
  double side = root_;
  Cell* cell = &root(number);
  const List* nearest = &all_;
  for (int level = 0;; ++level) {
    const Eigen::Vector3d from_middle = side * (within.array() - 0.5).matrix();
    if (cell->distance < 0) {
      cell->distance =
          static_cast<float>(measure(point - from_middle, kMostOffset * side, *nearest));
    }
    const auto distance = static_cast<double>(cell->distance);
    const double offset = from_middle.norm() + kRounding * distance;
    const Clearance::Bounds bounds{std::max(0.0, distance - offset), distance + offset};
    if (level == last_level || settled(bounds, offset)) return bounds;
    if (cell->parts < 0) cell->parts = cut(*cell, point - from_middle, side, *nearest);
    Block& block = *blocks_[static_cast<std::size_t>(cell->parts)];
    if (level == kFinestLevel) {
      const double exact = measure(point, offset, block.nearest);
      return {exact, exact};
    }
    within *= kParts;
    const Eigen::Vector3i part = within.cast<int>().cwiseMin(kParts - 1);
    within -= part.cast<double>();
    side /= kParts;
    const int index = (part.x() * kParts + part.y()) * kParts + part.z();
    cell = &block.cells[static_cast<std::size_t>(index)];
    nearest = &block.nearest;
  }
}

}  // namespace graspless::collision
