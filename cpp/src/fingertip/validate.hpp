// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "graspless/fingertip/fingertip.hpp"

namespace graspless::fingertip {

/// The part of validate(Problem) that is about its motion.
void check_motion(const Problem& problem);

/// What a search over so many locations takes, at least [bytes].
double memory_needed(const Problem& problem, const Options& options, double num_locations);

/// What the tables of a lattice of poses come to, at most [bytes]; 0 for other motions.
double lattice_memory(const Problem& problem, double num_locations);

}  // namespace graspless::fingertip
