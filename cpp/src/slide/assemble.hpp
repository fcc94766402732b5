// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "slide/interruption.hpp"
#include "slide/motions.hpp"

namespace graspless::slide {

/// Writes the plan's segments: the slide, and the motions before and after it that belong to the
/// valid pair.
GRASPLESS_API void assemble(Query& query, const Motions& motions, const planning::Path& slide,
                            Plan& plan);

/// Puts the segment `retreat` before those of a plan that begins at its end.
void prepend_retreat(const Query& query, const Retreat& retreat, Plan& plan);

}  // namespace graspless::slide
