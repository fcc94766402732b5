// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/mechanics/stability.hpp"

namespace graspless::mechanics {

/// Problem (6) in one piece. The contact set, modes and directions must have been validated.
/// Throws std::runtime_error when no answer holds its residuals.
Stability max_stability_reference(const ContactSet& set, const std::vector<FingerMode>& modes,
                                  const Matrix6Xd& directions);

/// Problem (5). The same preconditions.
bool internal_force_is_bounded_reference(const ContactSet& set,
                                         const std::vector<FingerMode>& modes);

}  // namespace graspless::mechanics
