// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fingertip/lattice/bounds.hpp"
#include "fingertip/lattice/distances.hpp"
#include "fingertip/lattice/space.hpp"
#include "fingertip/model/path_query.hpp"

namespace graspless::fingertip {

/// Ways through the lattice with regrasps, for when there are none without, or dear ones.
/// lower_bound holds for ways with regrasps. Small graphs are
/// searched by A* to the end. In others a hasty search, which makes much of what is left of the way
/// and little of a regrasp, finds some route; its cost is not proven optimal then, and lower_bound
/// says what is.
Route search_regrasps(Workshop& workshop, LatticeSpace& space, LatticeBounds& bounds,
                      LatticeDistances& distances, planning::Clock& clock, Statistics& statistics);

}  // namespace graspless::fingertip
