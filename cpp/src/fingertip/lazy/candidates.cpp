// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Placements that may carry the object along some of the arcs, and what they cost at least.
#include "fingertip/lazy/candidates.hpp"

#include <algorithm>
#include <limits>

#include "graspless/watch.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kLittle = 1e-9;  // by which a stability must be below what is needed

}  // namespace

std::size_t PlacementHash::operator()(const Placement& placement) const {
  std::uint64_t hash = 0;
  for (const std::int32_t location : placement) {
    hash = (hash ^ static_cast<std::uint64_t>(location + 1)) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

Candidates::Candidates(const PoseGraph& graph, const StabilityBounds& bounds,
                       const Displacements& displacements)
    : graph_(graph), bounds_(bounds), displacements_(displacements) {
  std::unordered_map<int, int> slot_of;
  for (int arc = 0; arc < graph.num_arcs(); ++arc) {
    poll();
    for (int j = 0; j < graph.options.samples_per_arc; ++j) {
      const int instant = graph.instant(arc, j);
      const auto [entry, is_new] = slot_of.emplace(instant, static_cast<int>(instants_.size()));
      if (is_new) instants_.push_back(instant);
      slots_.push_back(entry->second);
    }
  }
}

std::vector<int> Candidates::instants(int arc) const {
  std::vector<int> distinct;
  for (int j = 0; j < graph_.options.samples_per_arc; ++j) {
    const int instant = graph_.instant(arc, j);
    if (std::find(distinct.begin(), distinct.end(), instant) == distinct.end()) {
      distinct.push_back(instant);
    }
  }
  return distinct;
}

int Candidates::open(const Placement& placement) {
  const auto [entry, is_new] = index_.try_emplace(placement, size());
  if (!is_new) return entry->second;
  const int c = size(), arcs = graph_.num_arcs();
  all_.push_back({placement});
  z_.resize(z_.size() + instants_.size(), kInfinity);
  weight_.resize(z_.size(), 1.0);
  known_.resize(z_.size(), Known::bound);
  before_.push_back(0);
  for (int arc = 0; arc < arcs; ++arc) {
    arcs_.push_back(displacements_.in_part(arc, placement) * graph_.options.samples_per_arc);
    before_.push_back(before_.back() + arcs_.back());
  }
  after_.resize(before_.size(), 0.0);
  double* after = &after_[sum_index(c)];
  for (int arc = arcs - 1; arc >= 0; --arc) after[arc] = after[arc + 1] + this->arc(c, arc);
  return c;
}

int Candidates::enter(const Placement& placement) {
  const int c = open(placement);
  at(c).is_entered = true;
  return c;
}

bool Candidates::is_entered(const Placement& placement) const {
  const auto entry = index_.find(placement);
  return entry != index_.end() && at(entry->second).is_entered;
}

void Candidates::set_stability(int c, int slot, double z) {
  const std::size_t i = slot_index(c, slot);
  z_[i] = z;
  weight_[i] = z > 0 ? 1 + graph_.options.stability_weight / z : kInfinity;
}

bool Candidates::tighten(int c, int slot) {
  const std::size_t i = slot_index(c, slot);
  const int instant = instants_[slot];
  if (known_[i] == Known::solved || bounds_.stamp(instant) <= at(c).stamp) return false;
  const auto bound = static_cast<double>(bounds_.bound(instant, at(c).placement));
  if (bound >= z_[i]) return false;
  set_stability(c, slot, bound < graph_.options.min_stability ? 0 : bound);
  return true;
}

/// Eq. (9) with what is known of z.
double Candidates::tighten_arc(int c, int arc, bool& changed) {
  double& cost = arcs_[arc_index(c, arc)];
  if (cost == kInfinity) return cost;
  bool is_lower = cost < 0;  // not computed yet
  const int samples = graph_.options.samples_per_arc;
  for (int j = 0; j < samples; ++j) is_lower |= tighten(c, slot(arc, j));
  // Slots that several arcs share tell only the first of them.
  if (is_lower || static_cast<int>(instants_.size()) < graph_.num_arcs() * samples) {
    double weight = 0;
    for (int j = 0; j < samples; ++j) weight += weight_[slot_index(c, slot(arc, j))];
    const double now =
        weight < kInfinity ? displacements_.in_part(arc, at(c).placement) * weight : kInfinity;
    changed |= now != cost;
    cost = now;
  }
  return cost;
}

bool Candidates::refresh(int c) {
  if (at(c).stamp >= bounds_.stamp()) return false;
  return update(c);
}

bool Candidates::update(int c) {
  bool changed = false;
  const int arcs = graph_.num_arcs();
  double* before = &before_[sum_index(c)];
  double* after = &after_[sum_index(c)];
  before[0] = after[arcs] = 0;
  int dead = arcs;  // the first arc that cannot be
  for (int arc = 0; arc < arcs; ++arc) {
    if (dead == arcs) before[arc + 1] = before[arc] + tighten_arc(c, arc, changed);
    if (dead == arcs && before[arc + 1] == kInfinity) dead = arc;
    if (dead < arcs) before[arc + 1] = kInfinity;
  }
  for (int arc = arcs - 1; arc >= 0; --arc) {
    const bool is_cut = after[arc + 1] == kInfinity || arc == dead;
    after[arc] = is_cut ? kInfinity
                        : after[arc + 1] + (dead == arcs ? arcs_[arc_index(c, arc)]
                                                         : tighten_arc(c, arc, changed));
  }
  for (int arc = dead; arc < arcs && keeps_inner_arcs_; ++arc) tighten_arc(c, arc, changed);
  at(c).stamp = bounds_.stamp();
  return changed;
}

void Candidates::refresh_all() {
  for (int c = 0; c < size(); ++c) {
    poll();
    refresh(c);
  }
}

void Candidates::keep_inner_arcs() {
  keeps_inner_arcs_ = true;
  for (int c = 0; c < size(); ++c) {
    poll();
    at(c).stamp = 0;
    update(c);
  }
}

bool Candidates::request(int c, int first_arc, int last_arc, std::vector<StabilityQuery>& queries) {
  std::vector<int> open;
  bool any = false;
  for (int arc = first_arc; arc < last_arc; ++arc) {
    for (int j = 0; j < graph_.options.samples_per_arc; ++j) {
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
  std::partial_sort(open.begin(), open.begin() + count, open.end(), [&](int a, int b) {
    const double za = z_[slot_index(c, a)], zb = z_[slot_index(c, b)];
    return za != zb ? za < zb : a < b;
  });
  const bool is_whole = last_arc - first_arc == graph_.num_arcs();
  for (std::size_t i = 0; i < count; ++i) {
    request_slot(c, open[i], queries, is_whole ? needed(c, open[i]) : 0);
  }
  return any;
}

/// The stability at one instant below which the candidate costs more, all the way, than the best.
double Candidates::needed(int c, int slot) const {
  if (best_ == kInfinity) return 0;
  double displacement = 0;
  for (int arc = 0; arc < graph_.num_arcs(); ++arc) {
    for (int j = 0; j < graph_.options.samples_per_arc; ++j) {
      if (this->slot(arc, j) == slot) displacement += displacements_.in_part(arc, placement(c));
    }
  }
  const double weight = weight_[slot_index(c, slot)] + (best_ - after(c, 0)) / displacement;
  return weight > 1 ? graph_.options.stability_weight / (weight - 1) * (1 - kLittle) : 0;
}

bool Candidates::is_solved(int c, int first_arc, int last_arc) const {
  for (int arc = first_arc; arc < last_arc; ++arc) {
    for (int j = 0; j < graph_.options.samples_per_arc; ++j) {
      if (known_[slot_index(c, slot(arc, j))] != Known::solved) return false;
    }
    if (arcs_[arc_index(c, arc)] == kInfinity) return false;
  }
  return true;
}

void Candidates::request_slot(int c, int slot, std::vector<StabilityQuery>& queries,
                              double needed) {
  Known& known = known_[slot_index(c, slot)];
  if (known != Known::bound) return;
  known = Known::requested;
  StabilityQuery query;
  query.index = c;
  query.slot = slot;
  query.instant = instants_[slot];
  query.placement = at(c).placement;
  query.needed = needed;
  queries.push_back(std::move(query));
}

void Candidates::record(const StabilityQuery& query) {
  const int c = query.index;
  const bool is_bound = query.z > 0 && query.z < query.needed;
  const std::size_t i = slot_index(c, query.slot);
  set_stability(c, query.slot, is_bound ? std::min(query.z, z_[i]) : query.z);
  known_[i] = is_bound ? Known::bound : Known::solved;
  if (!is_bound) ++at(c).solved;
  for (int arc = 0; arc < graph_.num_arcs(); ++arc) {
    double& cost = arcs_[arc_index(c, arc)];
    for (int j = 0; j < graph_.options.samples_per_arc && cost < kInfinity; ++j) {
      if (slot(arc, j) == query.slot) cost = -1;  // to be computed anew
    }
  }
  update(c);
  if (at(c).solved == static_cast<int>(instants_.size())) best_ = std::min(best_, after(c, 0));
}

std::int64_t Candidates::memory() const {
  const auto samples = static_cast<std::int64_t>(instants_.size());
  return size() * (100 + samples * 17 + (3 * graph_.num_arcs() + 2) * 8);
}

}  // namespace graspless::fingertip
