// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fingertip/lattice/bounds.hpp"
#include "fingertip/model/pose_graph.hpp"
#include "fingertip/search/heuristic.hpp"

namespace graspless::fingertip {

/// Searches a lattice with lazily evaluated stabilities. Without regrasps if that can be done: then
/// the cost is the least over all paths through the lattice and all placements of the fingers. With
/// regrasps it is the least in small lattices only; else lower_bound says what is proven.
Route search_lattice(const PoseGraph& graph, Evaluator& evaluator, planning::Clock& clock,
                     Statistics& statistics);

/// The cheapest route without regrasps over all placements: by ascending lower bound, until that
/// reaches the best cost.
Route search_placements(const PoseGraph& graph, LatticeBounds& bounds, RemainingDistance& remaining,
                        planning::Clock& clock, Statistics& statistics);

}  // namespace graspless::fingertip
