// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/lazy/listing.hpp"

#include <algorithm>
#include <limits>

namespace graspless::fingertip {
namespace {

constexpr float kNone = std::numeric_limits<float>::infinity();
constexpr float kLevel = 0.85F;       // from one level of stability to the next
constexpr double kRounding = 1e-9;    // of costs summed in another order
constexpr double kRoundFloat = 1e-6;  // of stabilities in single precision

}  // namespace

Listing::Listing(LazyState& lazy)
    : lazy_(lazy),
      clear_(clear_locations(lazy.graph, 0, lazy.graph.num_arcs())),
      single_(lazy.candidates.instants().size() == 1),
      level_(kNone),
      least_cost_(lazy.displacements.least_whole()) {
  const std::vector<int>& all = lazy.candidates.instants();
  instants_ = {all.front(), all.back(), all[all.size() / 2]};
  if (all.size() < instants_.size()) instants_ = all;
  seed_bounds(lazy, clear_, instants_);
}

bool Listing::begins_anew() const {
  return single_ && lazy_.bounds.has_forgotten(instants_.front());
}

void Listing::next(const std::function<void(const Placement&, double)>& found) {
  const float before = begins_anew() ? kNone : level_;
  const float least = lazy_.min_stability;
  level_ = single_ ? std::max(least, next_level()) : least;
  for_each_placement(lazy_.graph, lazy_.bounds, lazy_.count, clear_, instants_, level_, lazy_.crew,
                     [&](const Placement& placement) {
                       const bool is_known =
                           single_ && (lazy_.bounds.bound(instants_.front(), placement) >= before ||
                                       lazy_.candidates.is_entered(placement));
                       if (!is_known) found(placement, cost(placement));
                       return true;
                     });
  if (level_ == least) {
    least_cost_ = kInfinity;
  } else if (level_ > needed()) {
    least_cost_ = cost_at(lazy_.displacements.least_whole(), level_);
  } else {
    least_cost_ = lazy_.candidates.best();
  }
}

double Listing::cost(const Placement& placement) const {
  double displacement = 0;
  for (const std::int32_t location : placement) {
    if (location < 0) break;
    displacement = std::max(displacement, *lazy_.displacements.after(location));
  }
  if (!single_) return displacement * (1 - kRounding);
  const float z = lazy_.bounds.bound(instants_.front(), placement);
  return z < level_ ? kInfinity : cost_at(displacement, z);
}

/// Cost (9) with the same stability all the way.
double Listing::cost_at(double displacement, float z) const {
  const double weight = lazy_.graph.options.stability_weight / static_cast<double>(z);
  return displacement * (1 + weight) * (1 - kRounding);
}

/// Once a candidate has been solved, only those that may cost less are of use.
float Listing::next_level() const {
  return std::max(kLevel * std::min(level_, greatest_bound()), needed());
}

/// No placement is bounded by more.
float Listing::greatest_bound() const {
  const int instant = instants_.front(), used = lazy_.bounds.used(instant);
  float least = kFree;
  for (int k = 0; k < used; ++k) {
    float most = 0;
    for (const int l : clear_) most = std::max(most, lazy_.bounds.block(instant, l)[k]);
    least =
        std::min(least, lazy_.bounds.offsets(instant)[k] + static_cast<float>(lazy_.count) * most);
  }
  return least;
}

/// With less stability, a placement costs more than the best candidate.
float Listing::needed() const {
  const double more = lazy_.candidates.best() / lazy_.displacements.least_whole() - 1;
  if (!(more > 0)) return 0;
  return static_cast<float>(lazy_.graph.options.stability_weight / more * (1 - kRoundFloat));
}

}  // namespace graspless::fingertip
