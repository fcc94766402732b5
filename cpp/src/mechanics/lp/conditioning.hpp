// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {

/// What the six rows of balance may be multiplied with, so that contacts which hardly resist some
/// wrench (points that are nearly on a line, say) do not sink below a solver's tolerance. The
/// identity where there is no need, or no wrench at all is resisted.
Matrix6d balance_conditioning(const EnvironmentWrenches& environment,
                              const std::vector<FingerWrenches>& fingers);

}  // namespace graspless::mechanics
