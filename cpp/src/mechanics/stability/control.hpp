// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {

/// Throws std::invalid_argument unless there is one control mode for each finger.
void validate_modes(const ContactSet& set, const std::vector<FingerMode>& modes);

/// Returns the modes as bits. Throws like validate_modes().
ForceMask force_mask(const ContactSet& set, const std::vector<FingerMode>& modes);

/// Throws std::invalid_argument unless there is one commanded force for each finger, and those of
/// fingers in force control lie between 0 and max_normal_force.
void validate_commanded_forces(const ContactSet& set, const std::vector<FingerMode>& modes,
                               const Eigen::VectorXd& commanded_forces);

/// Throws std::invalid_argument unless there is a direction, and all have a length within the
/// bounds of contact.hpp.
void validate_directions(const Matrix6Xd& directions);

}  // namespace graspless::mechanics
