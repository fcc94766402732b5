// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/cycles/cycle_basis.hpp"

#include <algorithm>

namespace graspless::geometry {

/// Index of the highest bit, or -1 for zero.
int CycleBasis::lead(const std::vector<Word>& cls) const {
  for (int w = words_ - 1; w >= 0; --w) {
    const Word word = cls[w];
    if (word != 0) return 64 * w + 63 - __builtin_clzll(word);
  }
  return -1;
}

/// Reduces a class by the first `count` rows. Returns true if nothing is left.
bool CycleBasis::depends(std::vector<Word>& cls, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i) {
    const Row& row = rows_[i];
    const bool has_lead = (cls[row.lead / 64] >> (row.lead % 64)) & 1;
    if (!has_lead) continue;
    for (std::size_t w = 0; w < cls.size(); ++w) cls[w] ^= row.bits[w];
  }
  return lead(cls) < 0;
}

bool CycleBasis::would_improve(const Word* cls, double length) const {
  if (length >= bound()) return false;
  std::size_t shorter = 0;
  while (shorter < members_.size() && members_[shorter].length <= length) ++shorter;
  scratch_.assign(cls, cls + words_);
  return !depends(scratch_, shorter);
}

double CycleBasis::bound(const Word* cls) const {
  scratch_.assign(cls, cls + words_);
  double longest = 0;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Row& row = rows_[i];
    if (!((scratch_[row.lead / 64] >> (row.lead % 64)) & 1)) continue;
    for (std::size_t w = 0; w < scratch_.size(); ++w) scratch_[w] ^= row.bits[w];
    longest = members_[i].length;
  }
  return lead(scratch_) < 0 ? longest : std::numeric_limits<double>::infinity();
}

void CycleBasis::offer(const Word* cls, double length, Cycle cycle) {
  if (!would_improve(cls, length)) return;
  const auto position =
      std::upper_bound(members_.begin(), members_.end(), length,
                       [](double value, const Member& member) { return value < member.length; });
  const auto first = static_cast<std::size_t>(position - members_.begin());
  members_.insert(position, {length, {cls, cls + words_}, std::move(cycle)});
  make_rows(first);
}

/// Gaussian elimination from the first new member on, in order of length. Removes members that
/// depend on shorter ones.
void CycleBasis::make_rows(std::size_t first) {
  rows_.resize(first);
  for (std::size_t i = first; i < members_.size();) {
    std::vector<Word> rest = members_[i].cls;
    if (depends(rest, rows_.size())) {
      members_.erase(members_.begin() + i);
      continue;
    }
    const int bit = lead(rest);
    rows_.push_back({std::move(rest), bit});
    ++i;
  }
}

std::vector<ClassCycle> CycleBasis::cycles() const {
  std::vector<ClassCycle> cycles;
  for (std::size_t i = 0; i < members_.size(); ++i)
    cycles.push_back({members_[i].cycle, rows_[i].lead});
  return cycles;
}

}  // namespace graspless::geometry
