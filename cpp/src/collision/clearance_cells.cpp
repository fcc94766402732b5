// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/clearance_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graspless/watch.hpp"

namespace graspless::collision {
namespace {

constexpr int kFirstBits = 8;
constexpr std::size_t kMaxListed = 1 << 23;  // 64 MB; beyond that the grid is cleared
constexpr std::size_t kMaxRoots = 1 << 20;
constexpr double kSmall = 0.1;  // of a cell's side

}  // namespace

ClearanceCells::ClearanceCells(std::shared_ptr<const Triangles> triangles,
                               std::shared_ptr<const ClearanceTree> tree, double cell)
    : triangles_(std::move(triangles)),
      tree_(std::move(tree)),
      all_(triangles_->size()),
      cell_(cell),
      root_(cell * std::pow(kParts, kCellLevel)),
      per_root_(1 / root_) {
  for (std::size_t i = 0; i < all_.size(); ++i) all_[i] = {0, static_cast<int>(i)};
  clear();
}

void ClearanceCells::clear() {
  slots_.assign(std::size_t{1} << kFirstBits, {0, -1});
  shift_ = 64 - kFirstBits;
  roots_.clear();
  blocks_.clear();
  listed_ = 0;
  last_root_ = -1;
}

/// Returns the slot of a key, or the free slot where it belongs.
std::size_t ClearanceCells::find(std::uint64_t key) const {
  auto i = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> shift_);
  while (slots_[i].root >= 0 && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
  return i;
}

ClearanceCells::Cell& ClearanceCells::root(const Number& number) {
  const auto key = static_cast<std::uint64_t>(number.x() << 42 | number.y() << 21 | number.z());
  if (last_root_ >= 0 && key == last_key_) return roots_[static_cast<std::size_t>(last_root_)];
  if (listed_ > kMaxListed || roots_.size() > kMaxRoots) clear();
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
    poll();
    if (slot.root >= 0) slots_[find(slot.key)] = slot;
  }
}

/// Returns the distance from a point at most `offset` from the centre of the cell that the list
/// belongs to.
double ClearanceCells::measure(const Eigen::Vector3d& point, double offset,
                               const List& nearest) const {
  double square = std::numeric_limits<double>::infinity(), distance = square;
  for (const Near& near : nearest) {
    if (static_cast<double>(near.distance) - offset >= distance) continue;
    const SurfaceTriangle& triangle = (*triangles_)[static_cast<std::size_t>(near.triangle)];
    const double reach = distance + triangle.radius;
    if ((point - triangle.middle).squaredNorm() >= reach * reach) continue;
    const double other = squared_distance(triangle, point);
    if (other >= square) continue;
    square = other;
    distance = std::sqrt(square);
  }
  return distance;
}

/// Makes a block for the parts of a cell. A point in the cell is at most half a diagonal h from its
/// centre, so the triangle nearest to the point is at most 2 h farther from the centre than the
/// triangle nearest to the centre.
int ClearanceCells::cut(const Cell& cell, const Eigen::Vector3d& middle, double side,
                        const List& nearest) {
  const double offset = kMostOffset * side;
  const double farthest =
      static_cast<double>(cell.distance) * (1 + kRounding) + 2.000001 * kHalfDiagonal * side;
  auto block = std::make_unique<Block>();
  List& list = block->nearest;
  for (const Near& near : nearest) {
    if (static_cast<double>(near.distance) - offset > farthest) continue;
    const SurfaceTriangle& triangle = (*triangles_)[static_cast<std::size_t>(near.triangle)];
    double least = (middle - triangle.middle).norm() - triangle.radius;
    if (least > farthest) continue;
    // In large cells the triangle's bounding sphere is as good as the triangle.
    if (triangle.radius > kSmall * side) least = std::sqrt(squared_distance(triangle, middle));
    if (least > farthest) continue;
    least *= 1 - kRounding;
    list.push_back({static_cast<float>(least), near.triangle});
    if (list.back().distance < list.front().distance) std::swap(list.front(), list.back());
  }
  listed_ += list.size() + sizeof(Block) / sizeof(Near);
  blocks_.push_back(std::move(block));
  return static_cast<int>(blocks_.size()) - 1;
}

}  // namespace graspless::collision
