// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Arguments of holds_over_friction(): validation, ends and middles of intervals.
#include "mechanics/stability/friction_query.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "mechanics/stability/control.hpp"
#include "text.hpp"

namespace graspless::mechanics {
namespace {

void validate_interval(const FrictionInterval& interval, const std::string& what) {
  const auto [lower, upper] = interval;
  if (lower >= 0 && lower <= upper && upper <= kMaxFriction) return;
  throw std::invalid_argument(what +
                              " must be an interval with 0 <= lower <= upper <= 10000, not " +
                              figure(lower) + " to " + figure(upper));
}

void validate_surfaces(const Surfaces& surfaces, std::size_t num_contacts) {
  if (surfaces.friction.empty()) {
    throw std::invalid_argument("environment must have one surface or more");
  }
  int uncertain = 0;
  for (const FrictionInterval& interval : surfaces.friction) {
    validate_interval(interval, "environment");
    uncertain += width(interval) > 0 ? 1 : 0;
  }
  if (uncertain > kMaxUncertainSurfaces) {
    throw std::invalid_argument("environment must have at most " +
                                std::to_string(kMaxUncertainSurfaces) +
                                " surfaces with lower < upper, not " + std::to_string(uncertain));
  }
  if (surfaces.of_contact.size() != num_contacts) {
    throw std::invalid_argument("environment must name the surface of each of the " +
                                std::to_string(num_contacts) + " contacts, not of " +
                                std::to_string(surfaces.of_contact.size()));
  }
  const auto count = static_cast<int>(surfaces.friction.size());
  for (const int surface : surfaces.of_contact) {
    if (surface >= 0 && surface < count) continue;
    throw std::invalid_argument("environment: the surface of a contact must be 0 to " +
                                std::to_string(count - 1) + ", not " + std::to_string(surface));
  }
}

template <typename Value>
Coefficients each(const Intervals& intervals, const Value& value) {
  Coefficients values(intervals.size());
  std::transform(intervals.begin(), intervals.end(), values.begin(), value);
  return values;
}

}  // namespace

void validate(const FrictionQuery& q) {
  validate(q.set);
  validate_modes(q.set, q.modes);
  validate_commanded_forces(q.set, q.modes, q.commanded_forces);
  validate_surfaces(q.environment, q.set.contacts.size());
  validate_interval(q.fingers, "fingers");
  if (!(q.needed >= 0) || !std::isfinite(q.needed)) {
    throw std::invalid_argument("needed must be a stability of 0 N or more, not " +
                                figure(q.needed));
  }
  validate_directions(q.directions);
}

Coefficients lower_ends(const Intervals& intervals) {
  return each(intervals, [](const FrictionInterval& interval) { return interval.lower; });
}
Coefficients upper_ends(const Intervals& intervals) {
  return each(intervals, [](const FrictionInterval& interval) { return interval.upper; });
}
Coefficients middles(const Intervals& intervals) {
  return each(intervals, [](const FrictionInterval& interval) {
    return (interval.lower + interval.upper) / 2;
  });
}

ContactSet with_friction(const FrictionQuery& q, const Coefficients& stick,
                         const Coefficients& slide, double fingers) {
  ContactSet set = q.set;
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    Contact& contact = set.contacts[i];
    contact.friction = (contact.mode == ContactMode::stick ? stick : slide)[q.surface(i)];
  }
  for (Finger& finger : set.fingers) finger.friction = fingers;
  return set;
}

std::vector<std::size_t> uncertain_surfaces(const FrictionQuery& q, ContactMode mode) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < q.set.contacts.size(); ++i) {
    const std::size_t s = q.surface(i);
    if (q.set.contacts[i].mode == mode && width(q.environment.friction[s]) > 0 &&
        std::find(found.begin(), found.end(), s) == found.end()) {
      found.push_back(s);
    }
  }
  return found;
}

std::vector<Coefficients> ends(const Intervals& intervals, const std::vector<std::size_t>& varied,
                               const Coefficients& others) {
  std::vector<Coefficients> found = {lower_ends(intervals), upper_ends(intervals)};
  const unsigned last = (1U << varied.size()) - 1;
  for (unsigned mask = 1; mask < last; ++mask) {
    found.push_back(others);
    for (std::size_t k = 0; k < varied.size(); ++k) {
      const FrictionInterval& interval = intervals[varied[k]];
      found.back()[varied[k]] = (mask >> k & 1U) != 0 ? interval.upper : interval.lower;
    }
  }
  return found;
}

}  // namespace graspless::mechanics
