// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Why a path was not found: geometry, stability or time.
#include <string>

#include "fingertip/planner.hpp"

namespace graspless::fingertip {
namespace {

/// Whether `missing` more fingers fit beside `kept` at a pose.
bool fits(const PathQuery& query, int pose, const Placement& kept, int first, int missing) {
  if (missing == 0) return true;
  for (int location = first; location < query.locations.size(); ++location) {
    if (!query.is_clear(pose, location)) continue;
    const Placement next = with(kept, location);
    if (!is_feasible(query, pose, next)) continue;
    if (fits(query, pose, next, location + 1, missing - 1)) return true;
  }
  return false;
}

/// The first pose at which no placement of the fingers is feasible; -1: none.
int first_blocked_pose(const PathQuery& query) {
  for (int pose = 0; pose < query.num_poses(); ++pose) {
    if (!fits(query, pose, kNoFingers, 0, query.num_fingers)) return pose;
  }
  return -1;
}

}  // namespace

void explain_failure(const PathQuery& query, const Route& route, planning::Clock& clock,
                     Plan& plan) {
  const int pose = route.is_complete ? first_blocked_pose(query) : -1;
  if (pose >= 0) {
    plan.status = Status::no_location;
    plan.reason = "no " + std::to_string(query.num_fingers) + " of the " +
                  std::to_string(query.locations.size()) +
                  " fingertip locations are clear of floor, walls, obstacles and each other at "
                  "pose " +
                  std::to_string(pose) + " of " + std::to_string(query.num_arcs());
  } else if (route.is_complete) {
    plan.status = Status::unstable;
    plan.reason =
        "fingers can be placed at every pose, but no sequence of placements keeps the "
        "object stable by min_stability = " +
        std::to_string(query.options.min_stability) + " N all the way";
  } else if (clock.was_interrupted()) {
    plan.status = Status::interrupted;
    plan.reason = "interrupted before a plan was found";
  } else {
    plan.status = Status::out_of_time;
    plan.reason = "the budget was spent before a plan was found; none is cheaper than " +
                  std::to_string(route.lower_bound);
  }
}

}  // namespace graspless::fingertip
