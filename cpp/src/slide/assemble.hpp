// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "slide/motions.hpp"

namespace graspless::slide {

/// Whether the robot at home, hand open, touches nothing; otherwise the plan says what touches.
bool is_home_free(Query& query, Plan& plan);

/// Writes the segments: the approach and handling of the valid pair around the slide.
GRASPLESS_API void assemble(Query& query, const Motions& motions, const planning::Path& slide,
                            Plan& plan);

/// One sentence on the plan's status, from its counters.
std::string reason(const Plan& plan);

}  // namespace graspless::slide
