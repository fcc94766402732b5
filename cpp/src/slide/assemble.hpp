// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "slide/motions.hpp"

namespace graspless::slide {

/// True if the robot at q_home can open its hand without collision. Otherwise sets the plan's
/// status and reason.
bool is_home_free(Query& query, Plan& plan);

/// Writes the plan's segments: the slide, and the motions before and after it that belong to the
/// valid pair.
GRASPLESS_API void assemble(Query& query, const Motions& motions, const planning::Path& slide,
                            Plan& plan);

/// Describes the plan's status in one sentence, from its statistics.
std::string reason(const Plan& plan);

}  // namespace graspless::slide
