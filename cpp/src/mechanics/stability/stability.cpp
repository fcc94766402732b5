// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Problems (5) and (6) for contact sets of users: validated, solved by either engine.
#include "graspless/mechanics/stability.hpp"

#include "graspless/mechanics/stability_solver.hpp"

#include "mechanics/stability/control.hpp"
#include "mechanics/stability/reference.hpp"

namespace graspless::mechanics {

Stability max_stability(const ContactSet& set, const std::vector<FingerMode>& modes,
                        const Matrix6Xd& directions, Engine engine) {
  validate(set);
  const ForceMask mask = force_mask(set, modes);
  StabilitySolver solver(directions);
  if (engine == Engine::reference) return Reference(set).max_stability(mask, directions);
  solver.set(set);
  return solver.max_stability(mask);
}

bool internal_force_is_bounded(const ContactSet& set, const std::vector<FingerMode>& modes,
                               Engine engine) {
  validate(set);
  const ForceMask mask = force_mask(set, modes);
  if (engine == Engine::reference) return Reference(set).internal_force_is_bounded(mask);
  StabilitySolver solver;
  solver.set(set);
  return solver.internal_force_is_bounded(mask);
}

}  // namespace graspless::mechanics
