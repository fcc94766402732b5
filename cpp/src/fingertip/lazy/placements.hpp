// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "fingertip/lazy/state.hpp"

namespace graspless::fingertip {

/// Calls found(placement) for all placements on these locations (ascending) for which the bounds at
/// these instants allow min_stability, in lexicographic order, until it returns false.
void for_each_placement(const PoseGraph& graph, const StabilityBounds& bounds, int count,
                        const std::vector<int>& locations, const std::vector<int>& instants,
                        const std::function<bool(const Placement&)>& found);

/// Solves a few placements at the instants, until their functionals exclude nearly all placements
/// that can be excluded.
void seed_bounds(LazyState& lazy, const std::vector<int>& locations,
                 const std::vector<int>& instants);

/// Opens all placements that the bounds allow at the instants.
void open_all(LazyState& lazy, const std::vector<int>& locations, const std::vector<int>& instants);

/// Locations clear at all poses from `first` to `last`.
std::vector<int> clear_locations(const PoseGraph& graph, int first, int last);

}  // namespace graspless::fingertip
