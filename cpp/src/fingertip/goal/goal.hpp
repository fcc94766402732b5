// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fingertip/planner.hpp"

namespace graspless::fingertip {

/// Plans a problem whose motion is a Goal: sequences of tumbles from the start's face to the
/// goal's, the fewest tumbles first, each with one slide and one turn before, between or after
/// (goal_paths); every path is searched as one of one degree of freedom by the engine of the
/// options. The answer is the best over the paths with the fewest tumbles that can be done, and
/// lower_bound holds for these paths. Where regrasps are needed, paths that could be cheaper by
/// less than a thousandth are left out: lower_bound is that much below the cost then. Throws
/// std::invalid_argument when the object does not stand on the floor by itself at start or goal.
Plan plan_goal(SearchContext& context, const Goal& goal, planning::Clock& clock);

}  // namespace graspless::fingertip
