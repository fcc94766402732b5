// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Placements that may carry the object along some of the arcs, and what they cost at least.
#include "fingertip/fast_candidates.hpp"

#include <algorithm>
#include <limits>

namespace graspless::fingertip {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

std::size_t PlacementHash::operator()(const Placement& placement) const {
  std::uint64_t hash = 0;
  for (const std::int32_t location : placement) {
    hash = (hash ^ static_cast<std::uint64_t>(location + 1)) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

Candidates::Candidates(const PathQuery& query, const Supports& supports)
    : query_(query), supports_(supports) {
  std::unordered_map<int, int> slot_of;
  for (int arc = 0; arc < query.num_arcs(); ++arc) {
    for (int j = 0; j < query.options.samples_per_arc; ++j) {
      const int instant = query.instant(arc, j);
      const auto [entry, is_new] = slot_of.emplace(instant, static_cast<int>(instants_.size()));
      if (is_new) instants_.push_back(instant);
      slots_.push_back(entry->second);
    }
  }
}

int Candidates::open(const Placement& placement) {
  const auto [entry, is_new] = index_.emplace(placement, size());
  if (!is_new) return entry->second;
  const int c = size();
  all_.push_back({placement});
  z_.resize(z_.size() + instants_.size(), kInfinity);
  known_.resize(known_.size() + instants_.size(), Known::bound);
  before_.resize(before_.size() + static_cast<std::size_t>(query_.num_poses()), kInfinity);
  after_.resize(after_.size() + static_cast<std::size_t>(query_.num_poses()), kInfinity);
  bool was_clear = is_feasible(query_, 0, placement);
  for (int arc = 0; arc < query_.num_arcs(); ++arc) {
    const bool is_clear = is_feasible(query_, arc + 1, placement);
    arcs_.push_back(was_clear && is_clear ? -1 : kInfinity);
    was_clear = is_clear;
  }
  update(c, true);
  return c;
}

bool Candidates::tighten(int c, int slot) {
  const std::size_t i = slot_index(c, slot);
  const int instant = instants_[static_cast<std::size_t>(slot)];
  if (known_[i] == Known::solved || supports_.stamp(instant) <= at(c).stamp) return false;
  const double bound = static_cast<double>(supports_.bound(instant, at(c).placement));
  if (bound >= z_[i]) return false;
  z_[i] = bound < query_.options.min_stability ? 0 : bound;
  return true;
}

double Candidates::cost(int c, int arc) const {
  constexpr int kMany = 64;
  double few[kMany];
  std::vector<double> many;
  const int samples = query_.options.samples_per_arc;
  double* z = few;
  if (samples > kMany) {
    many.resize(static_cast<std::size_t>(samples));
    z = many.data();
  }
  for (int j = 0; j < samples; ++j) {
    z[j] = z_[slot_index(c, slot(arc, j))];
    if (z[j] <= 0) return kInfinity;
  }
  return arc_cost(query_, arc, at(c).placement, z);
}

bool Candidates::refresh(int c) {
  if (at(c).stamp >= supports_.stamp()) return false;
  return update(c, false);
}

bool Candidates::update(int c, bool all) {
  bool changed = all;
  const auto tightened = [&](int arc) {
    double& value = arcs_[arc_index(c, arc)];
    if (value == kInfinity) return kInfinity;
    bool lower = all || value < 0;
    for (int j = 0; j < query_.options.samples_per_arc; ++j) lower |= tighten(c, slot(arc, j));
    if (lower) {
      value = cost(c, arc);
      changed = true;
    }
    return value;
  };
  const int arcs = query_.num_arcs();
  double sum = 0;
  int first_dead = arcs;
  before_[sum_index(c, 0)] = 0;
  for (int arc = 0; arc < arcs; ++arc) {
    if (sum < kInfinity) {
      sum += tightened(arc);
      if (sum == kInfinity) first_dead = arc;
    }
    before_[sum_index(c, arc + 1)] = sum;
  }
  sum = 0;
  after_[sum_index(c, arcs)] = 0;
  for (int arc = arcs - 1; arc >= 0; --arc) {
    if (arc <= first_dead && first_dead < arcs) sum = kInfinity;
    if (sum < kInfinity) sum += first_dead == arcs ? arcs_[arc_index(c, arc)] : tightened(arc);
    after_[sum_index(c, arc)] = sum;
  }
  if (keeps_middles_) {
    for (int arc = first_dead; arc < arcs; ++arc) tightened(arc);
  }
  at(c).stamp = supports_.stamp();
  return changed;
}

void Candidates::keep_middles() {
  keeps_middles_ = true;
  for (int c = 0; c < size(); ++c) {
    at(c).stamp = 0;
    update(c, true);
  }
}

bool Candidates::ask(int c, int first_arc, int last_arc, std::vector<Question>& questions) {
  std::vector<int> open;
  bool any = false;
  for (int arc = first_arc; arc < last_arc; ++arc) {
    for (int j = 0; j < query_.options.samples_per_arc; ++j) {
      const int s = slot(arc, j);
      const Known known = known_[slot_index(c, s)];
      any |= known != Known::solved;
      if (known == Known::bound) open.push_back(s);
    }
  }
  // The lower the bound the likelier the failure.
  std::sort(open.begin(), open.end());
  open.erase(std::unique(open.begin(), open.end()), open.end());
  const std::size_t count =
      std::min(open.size(), static_cast<std::size_t>(std::max(1, at(c).solved)));
  std::partial_sort(open.begin(), open.begin() + static_cast<std::ptrdiff_t>(count), open.end(),
                    [&](int a, int b) {
                      const double za = z_[slot_index(c, a)], zb = z_[slot_index(c, b)];
                      return za != zb ? za < zb : a < b;
                    });
  for (std::size_t i = 0; i < count; ++i) ask_slot(c, open[i], questions);
  return any;
}

void Candidates::ask_slot(int c, int slot, std::vector<Question>& questions) {
  Known& known = known_[slot_index(c, slot)];
  if (known != Known::bound) return;
  known = Known::asked;
  Question question;
  question.index = c;
  question.slot = slot;
  question.instant = instants_[static_cast<std::size_t>(slot)];
  question.placement = at(c).placement;
  questions.push_back(std::move(question));
}

void Candidates::learn(const Question& question) {
  const int c = question.index;
  const std::size_t i = slot_index(c, question.slot);
  z_[i] = question.z;
  known_[i] = Known::solved;
  ++at(c).solved;
  for (int arc = 0; arc < query_.num_arcs(); ++arc) {
    for (int j = 0; j < query_.options.samples_per_arc; ++j) {
      double& value = arcs_[arc_index(c, arc)];
      if (slot(arc, j) == question.slot && value < kInfinity) value = cost(c, arc);
    }
  }
  update(c, false);
}

std::int64_t Candidates::bytes_each(const PathQuery& query) {
  const std::int64_t arcs = query.num_arcs();
  return 64 + arcs * query.options.samples_per_arc * 9 + (3 * arcs + 2) * 8;
}

std::int64_t Candidates::memory() const { return size() * bytes_each(query_); }

}  // namespace graspless::fingertip
