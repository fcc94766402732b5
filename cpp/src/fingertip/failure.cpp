// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Why a route was not found: geometry, stability or time.
#include <cmath>
#include <string>

#include "fingertip/planner.hpp"
#include "fingertip/search/heuristic.hpp"

namespace graspless::fingertip {
namespace {

/// True if `missing` more fingers fit beside `kept` at a pose.
bool fits(const PoseGraph& graph, int pose, const Placement& kept, int first, int missing) {
  if (missing == 0) return true;
  for (int location = first; location < graph.locations.size(); ++location) {
    if (!has_room(graph, pose, kept, location)) continue;
    if (fits(graph, pose, with(kept, location), location + 1, missing - 1)) return true;
  }
  return false;
}

/// The first pose of a path at which no placement of the fingers is feasible; -1: none.
int first_blocked_pose(const PoseGraph& graph) {
  for (int pose = 0; pose < graph.num_poses(); ++pose) {
    if (!fits(graph, pose, kNoFingers, 0, graph.num_fingers)) return pose;
  }
  return -1;
}

void blame_geometry_of_path(const PoseGraph& graph, Plan& plan) {
  const int pose = first_blocked_pose(graph);
  if (pose < 0) return;
  plan.status = Status::no_location;
  plan.reason =
      "no " + std::to_string(graph.num_fingers) + " of the " +
      std::to_string(graph.locations.size()) +
      " fingertip locations are clear of floor, walls, obstacles and each other at pose " +
      std::to_string(pose) + " of " + std::to_string(graph.num_arcs());
}

void blame_geometry_of_lattice(const PoseGraph& graph, Plan& plan) {
  int num_clear = 0;
  for (int l = 0; l < graph.locations.size(); ++l) {
    if (graph.is_clear(graph.start(), l) && graph.is_clear(graph.goal(), l)) ++num_clear;
  }
  const bool is_open = graph.locations.size() > 0 &&
                       std::isfinite(RemainingDistance(graph).to_goal(0)[graph.start()]);
  if (is_open && num_clear >= graph.num_fingers) return;
  plan.status = Status::no_location;
  if (!is_open) {
    plan.limit = "reach of the lattice";
    plan.reason = "walls or obstacles stop the object on every path through the lattice";
  } else {
    plan.reason = "only " + std::to_string(num_clear) +
                  " fingertip locations are clear of floor, walls and obstacles at start and goal";
  }
}

void blame_incomplete_search(const PoseGraph& graph, const Route& route, planning::Clock& clock,
                             Plan& plan) {
  if (clock.was_interrupted()) {
    plan.status = Status::interrupted;
    plan.reason = "interrupted before a plan was found";
    return;
  }
  plan.status = Status::out_of_time;
  plan.reason = graph.is_path() || !clock.spend()
                    ? "the budget was spent before a plan was found; none is cheaper than " +
                          std::to_string(route.lower_bound)
                    : "no plan with at most " + std::to_string(graph.options.max_regrasps) +
                          " regrasps was found; none is excluded";
}

}  // namespace

void explain_failure(const PoseGraph& graph, const Route& route, planning::Clock& clock,
                     Plan& plan) {
  if (!route.is_complete) return blame_incomplete_search(graph, route, clock, plan);
  plan.status = Status::unstable;
  plan.reason =
      std::string(graph.is_path() ? "fingers can be placed at every pose, but no sequence of "
                                    "placements keeps the object stable by min_stability = "
                                  : "no route through the lattice keeps the object stable by "
                                    "min_stability = ") +
      std::to_string(graph.options.min_stability) + " N all the way";
  graph.is_path() ? blame_geometry_of_path(graph, plan) : blame_geometry_of_lattice(graph, plan);
}

}  // namespace graspless::fingertip
