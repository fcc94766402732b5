// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Slides and turns through a lattice of poses in the plane.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "fingertip/assemble.hpp"
#include "fingertip/lattice/regrasps.hpp"
#include "fingertip/lattice/search.hpp"
#include "fingertip/motions.hpp"

namespace graspless::fingertip {
namespace {

std::vector<Stage> stages_of(const LatticeSpace& space, const Route& route) {
  std::vector<Stage> stages;
  for (const Node& node : route.nodes) {
    if (stages.empty() || stages.back().placement != node.placement) {
      stages.push_back({node.placement, {}});
    }
    stages.back().X_WO.push_back(space.X_WO(node.pose));
  }
  return stages;
}

/// Why there is no route.
void explain(const Workshop& workshop, LatticeSpace& space, LatticeDistances& distances,
             const Route& route, planning::Clock& clock, Plan& plan) {
  int clear = 0;
  bool is_free_way = false;
  for (int l = 0; l < workshop.locations.size(); ++l) {
    if (space.is_clear(space.start(), l) && space.is_clear(space.goal(), l)) ++clear;
    const double distance =
        distances.to_goal(l, std::numeric_limits<double>::infinity())[space.start()];
    is_free_way = is_free_way || std::isfinite(distance);
  }
  if (!route.is_complete) {
    plan.status = clock.was_interrupted() ? Status::interrupted : Status::out_of_time;
    plan.reason = clock.was_interrupted() ? "interrupted before a plan was found"
                  : !clock.spend()
                      ? "the budget was spent before a plan was found"
                      : "no plan with at most " + std::to_string(workshop.options.max_regrasps) +
                            " regrasps was found; none is excluded";
  } else if (!is_free_way) {
    plan.status = Status::no_location;
    plan.limit = "reach of the lattice";
    plan.reason = "walls or obstacles stop the object on every way through the lattice";
  } else if (clear < workshop.problem.fingers.count) {
    plan.status = Status::no_location;
    plan.reason = "only " + std::to_string(clear) +
                  " fingertip locations are clear of floor, walls and obstacles at start and goal";
  } else {
    plan.status = Status::unstable;
    plan.reason = "no way through the lattice keeps the object stable by min_stability = " +
                  std::to_string(workshop.options.min_stability) + " N all the way";
  }
}

/// A route without regrasps that costs more than one is compared with routes that have some.
void consider_regrasps(Workshop& workshop, LatticeSpace& space, LatticeBounds& bounds,
                       planning::Clock& clock, Statistics& statistics, Route& route) {
  const double X_regr = workshop.options.regrasp_cost;
  if (workshop.options.max_regrasps == 0 || route.cost <= X_regr) return;
  route.lower_bound = std::min(route.lower_bound, X_regr);
  if (!route.is_complete) return;
  // The tables of the search so far leave out what its limits did.
  LatticeDistances distances(space, workshop.locations);
  Route other = search_regrasps(workshop, space, bounds, distances, clock, statistics);
  const double lower_bound = std::min(route.cost, other.lower_bound);
  const bool is_complete = other.is_complete;
  if (other.found && other.cost < route.cost) route = std::move(other);
  route.is_complete = is_complete;
  route.lower_bound = lower_bound;
}

}  // namespace

Plan plan_lattice(Workshop& workshop, const Lattice& lattice, planning::Clock& clock) {
  Plan plan;
  LatticeSpace space(workshop, lattice);
  if (space.start() == space.goal()) {
    throw std::invalid_argument("motion.X_WO_goal must differ from motion.X_WO_start");
  }
  LatticeBounds bounds(workshop);
  LatticeDistances distances(space, workshop.locations);
  Route route = search_placements(workshop, space, bounds, distances, clock, plan.statistics);
  if (!route.found && route.is_complete && workshop.options.max_regrasps > 0) {
    route = search_regrasps(workshop, space, bounds, distances, clock, plan.statistics);
  } else {
    consider_regrasps(workshop, space, bounds, clock, plan.statistics, route);
  }
  plan.statistics.supports = bounds.count();
  plan.statistics.memory = space.memory() + bounds.memory() + distances.memory();
  plan.lower_bound = route.lower_bound;
  if (!route.found) {
    explain(workshop, space, distances, route, clock, plan);
    return plan;
  }
  plan.status = Status::solved;
  assemble(stages_of(space, route), workshop.locations, workshop.instants,
           workshop.evaluators.front(), plan);
  if (route.is_complete) plan.lower_bound = plan.cost;
  return plan;
}

}  // namespace graspless::fingertip
