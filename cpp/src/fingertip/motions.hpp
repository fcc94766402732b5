// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fingertip/planner.hpp"

namespace graspless::fingertip {

/// Plans a problem whose motion is a Goal: sequences of tumbles from the start's face to the
/// goal's, the fewest tumbles first, each with slides and turns before, between and after
/// (goal_paths); every path is searched as one of one degree of freedom. The best over the paths
/// with the fewest tumbles that can be done is the answer, and lower_bound holds for these paths.
/// Throws std::invalid_argument when the object does not stand on the floor at start or goal.
Plan plan_goal(Workshop& workshop, const Goal& goal, planning::Clock& clock);

/// Plans a problem whose motion is a Lattice. Without regrasps when that can be done: then the cost
/// is the least over all ways through the lattice and all placements of the fingers.
Plan plan_lattice(Workshop& workshop, const Lattice& lattice, planning::Clock& clock);

}  // namespace graspless::fingertip
