// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Placements that may carry the object along some of the arcs, and what they cost at least.
#include "fingertip/lazy/candidates.hpp"

#include <algorithm>
#include <limits>

#include "graspless/watch.hpp"

namespace graspless::fingertip {
namespace {

constexpr int kPolledArcs = 64;  // between two polls

}  // namespace

std::size_t PlacementHash::operator()(const Placement& placement) const {
  std::uint64_t hash = 0;
  for (const std::int32_t location : placement) {
    hash = (hash ^ static_cast<std::uint64_t>(location + 1)) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

Candidates::Candidates(const PoseGraph& graph, const StabilityBounds& bounds)
    : graph_(graph), bounds_(bounds) {
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
  displacements_.reserve(static_cast<std::size_t>(graph.locations.size()) *
                         static_cast<std::size_t>(graph.num_arcs()));
  for (int location = 0; location < graph.locations.size(); ++location) {
    for (int arc = 0; arc < graph.num_arcs(); ++arc) {
      if (arc % kPolledArcs == 0) poll();
      const bool is_clear = graph.is_clear(arc, location) && graph.is_clear(arc + 1, location);
      displacements_.push_back(is_clear ? graph.displacement(arc, location) : kInfinity);
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

void Candidates::reserve(std::size_t more) {
  all_.reserve(all_.size() + more);
  index_.reserve(all_.size() + more);
}

int Candidates::open(const Placement& placement) {
  const auto [entry, is_new] = index_.emplace(placement, size());
  if (is_new) all_.push_back({placement});
  return entry->second;
}

/// Displacement of the finger that moves farthest, in a P-th of an arc; infinite where one is not
/// clear.
double Candidates::displacement(int arc, const Placement& placement) const {
  double reach = 0;
  const auto arcs = static_cast<std::size_t>(graph_.num_arcs());
  for (int i = 0; i < graph_.num_fingers; ++i) {
    const auto location = static_cast<std::size_t>(placement[static_cast<std::size_t>(i)]);
    reach = std::max(reach, displacements_[location * arcs + static_cast<std::size_t>(arc)]);
  }
  return reach;
}

/// Without the bounds, which are taken up when the candidate is part of a best route.
double Candidates::least_cost(int arc, int c) const {
  return displacement(arc, at(c).placement) * graph_.options.samples_per_arc;
}

Candidates::Sums Candidates::sums(int c) const {
  if (is_looked_at(c)) return {&before_[sum_index(c)], &after_[sum_index(c)]};
  const int arcs = graph_.num_arcs();
  const auto poses = static_cast<std::size_t>(graph_.num_poses());
  for (auto* values : {&some_arcs_, &some_before_, &some_after_}) values->resize(poses);
  double *cost = some_arcs_.data(), *before = some_before_.data(), *after = some_after_.data();
  before[0] = after[arcs] = 0;
  for (int arc = 0; arc < arcs; ++arc) {
    cost[arc] = least_cost(arc, c);
    before[arc + 1] = before[arc] + cost[arc];
  }
  for (int arc = arcs - 1; arc >= 0; --arc) after[arc] = after[arc + 1] + cost[arc];
  return {before, after};
}

Candidates::Reach Candidates::reach(int c) const {
  Reach reach{kInfinity, c, graph_.num_arcs(), -1};
  for (int arc = 0; arc < graph_.num_arcs(); ++arc) {
    const double cost = least_cost(arc, c);
    reach.least_arc = std::min(reach.least_arc, cost);
    if (cost < kInfinity) continue;
    reach.first_blocked = std::min(reach.first_blocked, arc);
    reach.last_blocked = arc;
  }
  return reach;
}

void Candidates::look_at(int c) {
  if (is_looked_at(c)) return;
  sums(c);
  arcs_.insert(arcs_.end(), some_arcs_.begin(), some_arcs_.end() - 1);  // one less than poses
  before_.insert(before_.end(), some_before_.begin(), some_before_.end());
  after_.insert(after_.end(), some_after_.begin(), some_after_.end());
  at(c).row = rows_++;
  z_.resize(z_.size() + instants_.size(), kInfinity);
  weight_.resize(z_.size(), 1.0);
  known_.resize(z_.size(), Known::bound);
}

void Candidates::set_stability(int c, int slot, double z) {
  const std::size_t i = slot_index(c, slot);
  z_[i] = z;
  weight_[i] = z > 0 ? 1 + graph_.options.stability_weight / z : kInfinity;
}

bool Candidates::tighten(int c, int slot) {
  const std::size_t i = slot_index(c, slot);
  const int instant = instants_[static_cast<std::size_t>(slot)];
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
    const double now = weight < kInfinity ? displacement(arc, at(c).placement) * weight : kInfinity;
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
  look_at(c);
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
  const auto arcs = static_cast<std::size_t>(graph_.num_arcs());
  arcs_.reserve(all_.size() * arcs);
  for (auto* values : {&before_, &after_}) values->reserve(all_.size() * (arcs + 1));
  for (int c = 0; c < size(); ++c) {
    poll();
    look_at(c);
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
  look_at(c);
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
  std::partial_sort(open.begin(), open.begin() + static_cast<std::ptrdiff_t>(count), open.end(),
                    [&](int a, int b) {
                      const double za = z_[slot_index(c, a)], zb = z_[slot_index(c, b)];
                      return za != zb ? za < zb : a < b;
                    });
  for (std::size_t i = 0; i < count; ++i) request_slot(c, open[i], queries);
  return any;
}

bool Candidates::is_solved(int c, int first_arc, int last_arc) const {
  if (at(c).row < 0) return false;
  for (int arc = first_arc; arc < last_arc; ++arc) {
    for (int j = 0; j < graph_.options.samples_per_arc; ++j) {
      if (known_[slot_index(c, slot(arc, j))] != Known::solved) return false;
    }
    if (arcs_[arc_index(c, arc)] == kInfinity) return false;
  }
  return true;
}

void Candidates::request_slot(int c, int slot, std::vector<StabilityQuery>& queries) {
  look_at(c);
  Known& known = known_[slot_index(c, slot)];
  if (known != Known::bound) return;
  known = Known::requested;
  StabilityQuery query;
  query.index = c;
  query.slot = slot;
  query.instant = instants_[static_cast<std::size_t>(slot)];
  query.placement = at(c).placement;
  queries.push_back(std::move(query));
}

void Candidates::record(const StabilityQuery& query) {
  const int c = query.index;
  set_stability(c, query.slot, query.z);
  known_[slot_index(c, query.slot)] = Known::solved;
  ++at(c).solved;
  for (int arc = 0; arc < graph_.num_arcs(); ++arc) {
    double& cost = arcs_[arc_index(c, arc)];
    for (int j = 0; j < graph_.options.samples_per_arc && cost < kInfinity; ++j) {
      if (slot(arc, j) == query.slot) cost = -1;  // to be computed anew
    }
  }
  update(c);
}

std::int64_t Candidates::bytes_each(const PoseGraph& graph) {
  return 100 + (3 * graph.num_arcs() + 2) * 8;
}

std::int64_t Candidates::memory() const {
  const auto samples = static_cast<std::int64_t>(instants_.size());
  return size() * bytes_each(graph_) + rows_ * samples * 17;
}

}  // namespace graspless::fingertip
