// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/clearance_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace graspless::collision {
namespace {

constexpr int kFirstBits = 8;
constexpr std::size_t kMaxBlocks = 1 << 16;  // some 60 MB; beyond that all is forgotten

}  // namespace

ClearanceCells::ClearanceCells(std::shared_ptr<const Triangles> triangles, double cell)
    : triangles_(std::move(triangles)),
      all_(triangles_->size()),
      cell_(cell),
      root_(cell * std::pow(kParts, kCellLevel)),
      per_root_(1 / root_) {
  std::iota(all_.begin(), all_.end(), 0);
  clear();
}

void ClearanceCells::clear() {
  slots_.assign(std::size_t{1} << kFirstBits, {0, -1});
  shift_ = 64 - kFirstBits;
  roots_.clear();
  blocks_.clear();
  last_root_ = -1;
}

/// Where a key is in the table, or the free slot where it would go.
std::size_t ClearanceCells::find(std::uint64_t key) const {
  auto i = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> shift_);
  while (slots_[i].root >= 0 && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
  return i;
}

ClearanceCells::Cell& ClearanceCells::root(const Number& number) {
  const auto key = static_cast<std::uint64_t>(number.x() << 42 | number.y() << 21 | number.z());
  if (last_root_ >= 0 && key == last_key_) return roots_[static_cast<std::size_t>(last_root_)];
  if (blocks_.size() > kMaxBlocks || roots_.size() > kMaxBlocks) clear();
  if (2 * roots_.size() >= slots_.size()) grow();
  Slot& slot = slots_[find(key)];
  if (slot.root < 0) {
    slot = {key, static_cast<int>(roots_.size())};
    roots_.emplace_back();
  }
  last_key_ = key;
  last_root_ = slot.root;
  return roots_[static_cast<std::size_t>(slot.root)];
}

void ClearanceCells::grow() {
  std::vector<Slot> old(2 * slots_.size(), {0, -1});
  old.swap(slots_);
  --shift_;
  for (const Slot& slot : old) {
    if (slot.root >= 0) slots_[find(slot.key)] = slot;
  }
}

void ClearanceCells::measure(Cell& cell, const Eigen::Vector3d& middle,
                             const std::vector<int>& nearest) const {
  double square = std::numeric_limits<double>::infinity(), distance = square;
  for (const int i : nearest) {
    const SurfaceTriangle& triangle = (*triangles_)[static_cast<std::size_t>(i)];
    const double reach = distance + triangle.radius;
    if ((middle - triangle.middle).squaredNorm() > reach * reach) continue;
    const double other = squared_distance(triangle, middle);
    if (other >= square) continue;
    square = other;
    distance = std::sqrt(square);
  }
  cell.distance = static_cast<float>(distance);
}

/// A new block for the parts of a cell. A point within it is at most half a diagonal h from its
/// middle: what is nearest to the point is at most 2 h farther from the middle than the nearest.
int ClearanceCells::cut(const Cell& cell, const Eigen::Vector3d& middle, double side,
                        const std::vector<int>& nearest) {
  const double farthest =
      static_cast<double>(cell.distance) * (1 + 1e-6) + std::sqrt(3.0) * side * (1 + 1e-9);
  auto block = std::make_unique<Block>();
  for (const int i : nearest) {
    const SurfaceTriangle& triangle = (*triangles_)[static_cast<std::size_t>(i)];
    const double reach = farthest + triangle.radius;
    if ((middle - triangle.middle).squaredNorm() > reach * reach) continue;
    if (squared_distance(triangle, middle) <= farthest * farthest) block->nearest.push_back(i);
  }
  blocks_.push_back(std::move(block));
  return static_cast<int>(blocks_.size()) - 1;
}

}  // namespace graspless::collision
