// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "slide/motions.hpp"

namespace graspless::slide {

/// Writes the plan's segments: the slide, and the motions before and after it that belong to the
/// valid pair.
GRASPLESS_API void assemble(Query& query, const Motions& motions, const planning::Path& slide,
                            Plan& plan);

}  // namespace graspless::slide
