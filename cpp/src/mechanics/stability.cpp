// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Problems (5) and (6) for somebody with contacts of their own: checked input, either engine.
#include "graspless/mechanics/stability.hpp"

#include <stdexcept>
#include <string>

#include "graspless/mechanics/stability_solver.hpp"

#include "mechanics/instant.hpp"
#include "mechanics/reference.hpp"

namespace graspless::mechanics {

Instant::Instant(const ContactSet& set) : environment(environment_wrenches(set)) {
  const int n = static_cast<int>(set.fingers.size());
  for (int i = 0; i < n; ++i) fingers.push_back(finger_wrenches(set, i));
}

void Instant::give_to(StabilitySolver& solver) const {
  std::vector<const FingerWrenches*> pointers;
  for (const FingerWrenches& finger : fingers) pointers.push_back(&finger);
  solver.set({&environment}, pointers);
}

ForceMask force_mask(const ContactSet& set, const std::vector<FingerMode>& modes) {
  if (modes.size() != set.fingers.size()) {
    throw std::invalid_argument(
        "modes must be one a finger: " + std::to_string(set.fingers.size()) + ", not " +
        std::to_string(modes.size()));
  }
  ForceMask mask = 0;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] == FingerMode::force) mask |= 1U << i;
  }
  return mask;
}

Stability max_stability(const ContactSet& set, const std::vector<FingerMode>& modes,
                        const Matrix6Xd& directions, Engine engine) {
  validate(set);
  const ForceMask mask = force_mask(set, modes);
  StabilitySolver solver(directions);
  if (engine == Engine::reference) return max_stability_reference(set, modes, directions);
  const Instant instant(set);
  instant.give_to(solver);
  return solver.max_stability(mask);
}

bool internal_force_is_bounded(const ContactSet& set, const std::vector<FingerMode>& modes,
                               Engine engine) {
  validate(set);
  const ForceMask mask = force_mask(set, modes);
  if (engine == Engine::reference) return internal_force_is_bounded_reference(set, modes);
  StabilitySolver solver;
  const Instant instant(set);
  instant.give_to(solver);
  return solver.internal_force_is_bounded(mask);
}

}  // namespace graspless::mechanics
