// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Regrasps on a lattice: to the end in small graphs, in haste in large ones.
#include "fingertip/lattice/regrasps.hpp"

#include <algorithm>
#include <limits>

#include "fingertip/lattice/graph.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSmallGraph = 3e5;  // nodes that are searched to the end
constexpr std::size_t kHastyNodes = 2000000;
constexpr double kHaste = 2.5;

/// Of all sphere centres, how far one has to go at least: some finger goes all the way when there
/// is but one regrasp.
double least_distance(const Workshop& workshop, const LatticeSpace& space,
                      LatticeDistances& distances) {
  double least = kInfinity;
  for (int l = 0; l < workshop.locations.size(); ++l) {
    least = std::min(least, distances.to_goal(l, kInfinity)[space.start()]);
  }
  return least;
}

}  // namespace

Route search_regrasps(Workshop& workshop, LatticeSpace& space, LatticeBounds& bounds,
                      LatticeDistances& distances, planning::Clock& clock, Statistics& statistics) {
  const Options& options = workshop.options;
  LatticeGraph graph(workshop, space, bounds, distances);
  const auto within = [&](Route route) {
    if (!route.found || num_regrasps(route) <= options.max_regrasps) return route;
    Route none;  // dearer ones may have fewer regrasps
    none.lower_bound = route.lower_bound;
    return none;
  };
  if (graph.num_nodes() <= kSmallGraph) {
    return within(graph.search({options.regrasp_cost, 1, kHastyNodes}, clock, statistics));
  }
  const double least = least_distance(workshop, space, distances);
  // A regrasp counts as much as part of the way, more each time.
  Route best;
  best.cost = kInfinity;
  for (const double share : {0.1, 1.0}) {
    const Route route = graph.search(
        {std::min(options.regrasp_cost, share * least), kHaste, kHastyNodes}, clock, statistics);
    if (route.is_complete && !route.found) return route;  // there is none
    if (!route.found) break;
    if (num_regrasps(route) <= options.max_regrasps && route.cost < best.cost) best = route;
    if (best.found && num_regrasps(best) <= 1) break;
  }
  // Without regrasps all is known; with one, one finger at least goes all the way.
  const bool one_stays = workshop.problem.fingers.count > 1;
  best.lower_bound = std::min(
      best.cost, options.regrasp_cost + std::min(one_stays ? least : 0.0, options.regrasp_cost));
  best.is_complete = false;
  return best;
}

}  // namespace graspless::fingertip
