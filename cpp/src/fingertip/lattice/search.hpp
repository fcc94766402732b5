// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fingertip/lattice/bounds.hpp"
#include "fingertip/lattice/distances.hpp"
#include "fingertip/lattice/space.hpp"
#include "fingertip/model/path_query.hpp"

namespace graspless::fingertip {

/// The cheapest way through the lattice without regrasps, over all placements: by ascending lower
/// bound, until that reaches the best cost. Poses of the route's nodes are those of the space.
Route search_placements(Workshop& workshop, LatticeSpace& space, LatticeBounds& bounds,
                        LatticeDistances& distances, planning::Clock& clock,
                        Statistics& statistics);

}  // namespace graspless::fingertip
