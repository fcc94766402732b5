// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fingertip/lattice_bounds.hpp"
#include "fingertip/lattice_distances.hpp"
#include "fingertip/lattice_space.hpp"
#include "fingertip/path_query.hpp"

namespace graspless::fingertip {

/// The cheapest way through the lattice without regrasps, over all placements: by ascending lower
/// bound, until that reaches the best cost. Poses of the route's nodes are those of the space.
Route search_placements(Workshop& workshop, LatticeSpace& space, LatticeBounds& bounds,
                        LatticeDistances& distances, planning::Clock& clock,
                        Statistics& statistics);

}  // namespace graspless::fingertip
