// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {

/// Factor for the six rows of balance that keeps contacts which hardly resist some wrench (points
/// nearly on a line, for instance) above a solver's tolerance. The identity if there is no need, or
/// if some wrench is not resisted at all.
Matrix6d balance_conditioning(const EnvironmentWrenches& environment,
                              const std::vector<FingerWrenches>& fingers);

}  // namespace graspless::mechanics
