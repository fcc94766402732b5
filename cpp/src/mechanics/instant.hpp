// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {

/// The wrenches of one contact set, for the solver to point to.
struct Instant {
  explicit Instant(const ContactSet& set);
  void give_to(StabilitySolver& solver) const;

  EnvironmentWrenches environment;
  std::vector<FingerWrenches> fingers;
};

/// Throws std::invalid_argument unless there is one mode a finger.
ForceMask force_mask(const ContactSet& set, const std::vector<FingerMode>& modes);

}  // namespace graspless::mechanics
