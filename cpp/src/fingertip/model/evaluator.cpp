// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Asks the stability solver, once for each placement at each instant.
#include "fingertip/model/evaluator.hpp"

#include <algorithm>
#include <cstdint>

#include "mechanics/stability/mode_search.hpp"

namespace graspless::fingertip {

Evaluator::Evaluator(const Instants& instants, const Locations& locations, const Options& options)
    : instants_(instants),
      locations_(locations),
      options_(options),
      solver_(options.disturbance_directions) {}

std::size_t Evaluator::Hash::operator()(const Key& key) const {
  std::uint64_t h = static_cast<std::uint64_t>(key.instant);
  for (const std::int32_t location : key.placement) {
    h = (h ^ static_cast<std::uint32_t>(location)) * 0x9E3779B97F4A7C15U;
    h ^= h >> 29U;
  }
  return h;
}

double Evaluator::known(int instant, const Placement& placement) const {
  const auto entry = known_.find({instant, placement});
  return entry == known_.end() ? -1 : entry->second.z;
}

void Evaluator::adopt(const Evaluator& other, int instant, const Placement& placement) {
  const auto entry = other.known_.find({instant, placement});
  if (entry == other.known_.end()) return;
  const auto [own, is_new] = known_.try_emplace(entry->first, entry->second);
  if (!is_new || own->second.best < 0) return;
  own->second.best = static_cast<int>(bests_.size());
  bests_.push_back(other.bests_[entry->second.best]);
}

void Evaluator::forget() {
  known_.clear();
  bests_.clear();
}

void Evaluator::set(int instant, const Placement& placement) {
  environments_.clear();
  fingers_.clear();
  for (const auto& environment : instants_[instant].environments) {
    environments_.push_back(&environment);
  }
  for (const std::int32_t location : placement) {
    if (location >= 0) fingers_.push_back(&locations_.wrenches(location));
  }
  solver_.set(environments_, fingers_);
}

Evaluator::Known Evaluator::solve(int instant, const Placement& placement, double needed) {
  const auto entry = known_.find({instant, placement});
  if (entry != known_.end()) return entry->second;
  set(instant, placement);
  const double least = options_.min_stability;
  const Best best = solver_.best_control_modes(std::max(least, needed));
  if (!best.found && best.z >= least) return {best.z, -1};  // enough to know, but not all
  Known known{0, -1};
  if (best.found && best.z >= least) {
    known = {best.z, static_cast<int>(bests_.size())};
    bests_.push_back(best);
  }
  known_.emplace(Key{instant, placement}, known);
  return known;
}

double Evaluator::stability(int instant, const Placement& placement, double needed) {
  return solve(instant, placement, needed).z;
}

mechanics::ControlModes Evaluator::control_modes(int instant, const std::vector<int>& fingers,
                                                 const std::vector<FingerMode>& previous) {
  Placement placement = kNoFingers;
  for (const int location : fingers) placement = with(placement, location);
  mechanics::ControlModes modes;
  const Known known = solve(instant, placement);
  if (known.best < 0) return modes;
  Best best = bests_[known.best];

  // Ties are broken among fingers in the order of the placement, as the masks are.
  const int n = num_fingers(placement);
  std::vector<int> at(placement.begin(), placement.begin() + n), rank;
  std::vector<FingerMode> before(previous.empty() ? 0 : fingers.size());
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    rank.push_back(static_cast<int>(std::find(at.begin(), at.end(), fingers[i]) - at.begin()));
    if (!before.empty()) before[rank[i]] = previous[i];
  }
  const mechanics::ForceMask mask = mechanics::break_tie(
      contact_set(instants_[instant], locations_, instants_.problem().fingers, at), best.ties,
      before);
  if (mask != best.force) {
    set(instant, placement);
    const mechanics::Stability other = solver_.max_stability(mask);
    best.z = other.z;
    best.commanded_forces.head(n) = other.commanded_forces;
  }
  modes.found = true;
  modes.stability.z = best.z;
  modes.stability.commanded_forces.resize(n);
  for (int i = 0; i < n; ++i) {
    const int k = rank[i];
    modes.modes.push_back((mask >> k & 1U) != 0 ? FingerMode::force : FingerMode::position);
    modes.stability.commanded_forces[i] = best.commanded_forces[k];
  }
  return modes;
}

mechanics::ContactSet contact_set(const Instant& instant, const Locations& locations,
                                  const Fingers& fingers, const std::vector<int>& at) {
  mechanics::ContactSet set = instant.set;
  for (const int i : at) {
    const Location& location = locations[i];
    set.fingers.push_back({location.p_OC, location.n_O, fingers.friction.lower,
                           fingers.max_normal_force, location.t_O});
  }
  return set;
}

}  // namespace graspless::fingertip
