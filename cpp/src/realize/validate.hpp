// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// What realize() and its check() refuse.
#pragma once

#include "graspless/realize/realize.hpp"

namespace graspless::fingertip {

/// Throws std::invalid_argument on options that are not positive, fingertips or links that the
/// robot does not have or that no joint moves, or a plan that is not solved or has not the shape
/// that its header says.
void validate_realization(const Problem& problem, const Plan& plan, const robot::Robot& robot,
                          const Carrier& carrier, const RealizeOptions& options);

}  // namespace graspless::fingertip
