// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/clearance_cells.hpp"

#include <cmath>
#include <utility>

#include "graspless/watch.hpp"

namespace graspless::collision {
namespace {

constexpr int kFirstBits = 8;
constexpr std::size_t kMaxBlocks = 1 << 16;  // 50 MB; beyond that the grid is cleared
constexpr std::size_t kMaxRoots = 1 << 20;

}  // namespace

ClearanceCells::ClearanceCells(std::shared_ptr<const ClearanceTree> tree, double cell)
    : tree_(std::move(tree)),
      cell_(cell),
      root_(cell * std::pow(kParts, kCellLevel)),
      per_root_(1 / root_) {
  clear();
}

ClearanceCells::ClearanceCells(const ClearanceCells& other)
    : tree_(other.tree_),
      cell_(other.cell_),
      root_(other.root_),
      per_root_(other.per_root_),
      slots_(other.slots_),
      shift_(other.shift_),
      roots_(other.roots_),
      last_key_(other.last_key_),
      last_root_(other.last_root_) {
  blocks_.reserve(other.blocks_.size());
  for (const auto& block : other.blocks_) {
    poll();
    blocks_.push_back(std::make_unique<Block>(*block));
  }
}

void ClearanceCells::clear() {
  slots_.assign(std::size_t{1} << kFirstBits, {0, -1});
  shift_ = 64 - kFirstBits;
  roots_.clear();
  blocks_.clear();
  last_root_ = -1;
}

/// Returns the slot of a key, or the free slot where it belongs.
std::size_t ClearanceCells::find(std::uint64_t key) const {
  auto i = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> shift_);
  while (slots_[i].root >= 0 && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
  return i;
}

/// The root of a key that is not the last one.
ClearanceCells::Cell& ClearanceCells::other_root(std::uint64_t key) {
  if (blocks_.size() > kMaxBlocks || roots_.size() > kMaxRoots) clear();
  if (2 * roots_.size() >= slots_.size()) grow();
  Slot& slot = slots_[find(key)];
  if (slot.root < 0) {
    roots_.emplace_back();
    slot = {key, static_cast<int>(roots_.size()) - 1};
  }
  last_key_ = key;
  last_root_ = slot.root;
  return roots_[slot.root];
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

}  // namespace graspless::collision
