// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/clearance_cells.hpp"

#include <algorithm>

namespace graspless::collision {
namespace {

constexpr int kFirstBits = 10;
constexpr std::size_t kMaxBlocks = 1 << 15;  // 64 MB; beyond that all is forgotten

}  // namespace

ClearanceCells::ClearanceCells(double cell)
    : cell_(cell), per_cell_(1 / cell), reach_(cell * static_cast<double>(kBias - 1)) {
  clear();
}

void ClearanceCells::clear() {
  slots_.assign(std::size_t{1} << kFirstBits, {0, nullptr});
  shift_ = 64 - kFirstBits;
  blocks_.clear();
  last_key_ = ~std::uint64_t{0};
}

float* ClearanceCells::add(std::uint64_t key) {
  if (blocks_.size() == kMaxBlocks) clear();
  if (2 * blocks_.size() >= slots_.size()) grow();
  blocks_.push_back(std::make_unique<float[]>(kBlock));
  float* values = blocks_.back().get();
  std::fill_n(values, kBlock, -1.0f);
  std::size_t i = place(key);
  while (slots_[i].values != nullptr) i = (i + 1) & (slots_.size() - 1);
  slots_[i] = {key, values};
  last_key_ = key;
  return last_ = values;
}

void ClearanceCells::grow() {
  std::vector<Slot> old(2 * slots_.size(), {0, nullptr});
  old.swap(slots_);
  --shift_;
  for (const Slot& slot : old) {
    if (slot.values == nullptr) continue;
    std::size_t i = place(slot.key);
    while (slots_[i].values != nullptr) i = (i + 1) & (slots_.size() - 1);
    slots_[i] = slot;
  }
}

}  // namespace graspless::collision
