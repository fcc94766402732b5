// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {

constexpr double kMaxScale = 1e9;  ///< of a force or moment [1 or 1/m]

/// As environment_wrenches() and finger_wrenches(), of a contact set that is known to be valid: a
/// search asks for those of thousands of sets, and validate() takes longer than they do.
EnvironmentWrenches wrenches_of_environment(const ContactSet& set);
std::vector<FingerWrenches> wrenches_of_fingers(const ContactSet& set);

}  // namespace graspless::mechanics
