// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Asks the stability solver, once for each placement at each instant.
#include "fingertip/evaluator.hpp"

#include <cstdint>

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
  return entry == known_.end() ? -1 : entry->second;
}

void Evaluator::set(int instant, const std::int32_t* fingers, int count) {
  environments_.clear();
  fingers_.clear();
  for (const auto& environment : instants_[instant].environments) {
    environments_.push_back(&environment);
  }
  for (int i = 0; i < count; ++i) fingers_.push_back(&locations_.wrenches(fingers[i]));
  solver_.set(environments_, fingers_);
}

double Evaluator::stability(int instant, const Placement& placement) {
  const auto [entry, is_new] = known_.try_emplace({instant, placement}, 0.0);
  if (!is_new) return entry->second;
  set(instant, placement.data(), num_fingers(placement));
  const auto best = solver_.best_control_modes(options_.min_stability);
  if (best.found && best.z >= options_.min_stability) entry->second = best.z;
  return entry->second;
}

mechanics::ControlModes Evaluator::control_modes(int instant, const std::vector<int>& fingers,
                                                 const std::vector<FingerMode>& previous) {
  const mechanics::ContactSet set =
      contact_set(instants_[instant], locations_, instants_.problem().fingers, fingers);
  return mechanics::best_control_modes(set, previous, options_.disturbance_directions);
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
