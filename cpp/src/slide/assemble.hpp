// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "slide/interruption.hpp"
#include "slide/motions.hpp"

namespace graspless::slide {

/// Returns the rows of a slide along a path of the arm, from its start; without its tube.
GRASPLESS_API Slid slid_along(Query& query, const planning::Path& slide);

/// Writes the plan's segments: the slide, and the motions before and after it that belong to the
/// valid pair.
GRASPLESS_API void assemble(const Query& query, const Motions& motions, const Slid& slide,
                            Plan& plan);

/// Puts the segment `retreat` before those of a plan that begins at its end.
void prepend_retreat(const Query& query, const Retreat& retreat, Plan& plan);

}  // namespace graspless::slide
