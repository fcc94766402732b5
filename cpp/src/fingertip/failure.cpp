// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reasons why a route was not found: geometry, stability or time.
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "graspless/collision/world.hpp"
#include "graspless/watch.hpp"

#include "fingertip/model/clearance.hpp"
#include "fingertip/model/locations.hpp"
#include "fingertip/planner.hpp"
#include "fingertip/search/heuristic.hpp"
#include "planning/plan_within.hpp"
#include "text.hpp"

namespace graspless::fingertip {
namespace {

/// True if `missing` more fingers fit beside those on `chosen`, on locations among clear[from ...].
bool fit(const Locations& locations, const std::vector<int>& clear, std::size_t from, int missing,
         std::vector<int>& chosen) {
  poll();
  if (missing == 0) return true;
  for (std::size_t i = from; i < clear.size(); ++i) {
    const bool apart = std::all_of(chosen.begin(), chosen.end(),
                                   [&](int other) { return locations.are_apart(clear[i], other); });
    if (!apart) continue;
    chosen.push_back(clear[i]);
    if (fit(locations, clear, i + 1, missing - 1, chosen)) return true;
    chosen.pop_back();
  }
  return false;
}

/// The first pose of a path at which no placement of the fingers is feasible; -1: none.
int first_blocked_pose(const PoseGraph& graph) {
  for (int pose = 0; pose < graph.num_poses(); ++pose) {
    std::vector<int> clear, chosen;
    for (int l = 0; l < graph.locations.size(); ++l) {
      if (graph.is_clear(pose, l)) clear.push_back(l);
    }
    if (!fit(graph.locations, clear, 0, graph.num_fingers, chosen)) return pose;
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

/// True if the object alone can move from start to goal. Poses near the goal come first.
bool leads_to_goal(const PoseGraph& graph) {
  const Eigen::Vector3d p_W = graph.X_WO(graph.goal()).translation();
  std::set<std::pair<double, int>> open;  // distance to the goal, pose
  std::vector<bool> is_known(graph.num_poses());
  const auto push = [&](int pose) {
    if (is_known[pose]) return;
    is_known[pose] = true;
    open.emplace((graph.X_WO(pose).translation() - p_W).norm(), pose);
  };
  push(graph.start());
  while (!open.empty()) {
    poll();
    const int pose = open.extract(open.begin()).value().second;
    if (pose == graph.goal()) return true;
    for (int move = 0; move < graph.num_moves(); ++move) {
      if (graph.kind(pose, move) >= 0) push(graph.next(pose, move));
    }
  }
  return false;
}

void blame_geometry_of_lattice(const PoseGraph& graph, Plan& plan) {
  int num_clear = 0;
  for (int l = 0; l < graph.locations.size(); ++l) {
    if (graph.is_clear(graph.start(), l) && graph.is_clear(graph.goal(), l)) ++num_clear;
  }
  const bool is_free = graph.locations.size() == 0 ||  // at the poses, which is soon known
                       std::isfinite(RemainingDistance(graph).to_goal(0)[graph.start()]);
  const bool is_open = is_free && leads_to_goal(graph);
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

/// The first finger that cannot be where it starts, and why; empty: there is none.
std::string fault_of_start(const PoseGraph& graph) {
  const std::vector<int>& start = graph.locations.start();
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (graph.is_clear(graph.start(), start[i])) continue;
    return "fingers.start[" + std::to_string(i) +
           "]: there the fingertip is not clear of floor, walls and obstacles";
  }
  return "";
}

void blame_incomplete_search(const PoseGraph& graph, const Route& route, planning::Clock& clock,
                             Plan& plan) {
  if (clock.was_interrupted() || clock.is_out_of_memory()) return blame_clock(clock, plan);
  plan.status = Status::out_of_time;
  plan.reason = graph.is_path() || !clock.spend()
                    ? "the budget was spent before a plan was found; none is cheaper than " +
                          figure(route.lower_bound)
                    : "no plan with at most " + std::to_string(graph.options.max_regrasps) +
                          " regrasps was found; none is excluded";
}

using Poses = std::vector<Eigen::Isometry3d>;

Poses needed_poses(const Path& path) { return path.X_WO; }
Poses needed_poses(const Lattice& lattice) { return {lattice.X_WO_start, lattice.X_WO_goal}; }
Poses needed_poses(const Goal& goal) { return {goal.X_WO_start, goal.X_WO_goal}; }

/// Number of locations that each plane and each obstacle keeps the fingertips from.
std::string in_the_way(const Problem& problem, const Locations& locations,
                       const Eigen::Isometry3d& X_WO) {
  std::ostringstream out;
  const auto count = [&](const std::string& who, const Problem& alone) {
    Clearance clearance(alone);
    int blocked = 0;
    for (int i = 0; i < locations.size(); ++i) {
      blocked += clearance.is_clear(X_WO * locations[i].center_O) ? 0 : 1;
    }
    if (blocked == 0) return;
    out << (out.tellp() > 0 ? ", " : "") << who << " blocks " << blocked;
  };
  Problem alone = problem;
  alone.obstacles.clear();
  for (const Plane& plane : problem.planes) {
    alone.planes = {plane};
    count("plane '" + plane.name + "'", alone);
  }
  alone.planes.clear();
  for (const Obstacle& obstacle : problem.obstacles) {
    alone.obstacles = {obstacle};
    count("obstacle '" + obstacle.label() + "'", alone);
  }
  return out.str();
}

}  // namespace

void blame_clock(const planning::Clock& clock, Plan& plan) {
  plan.status = Status::out_of_time;
  planning::blame_clock(
      clock, "fewer fingers, a smaller locations_per_side or a larger location_spacing", plan);
}

void explain_failure(const PoseGraph& graph, const Route& route, planning::Clock& clock,
                     Plan& plan) {
  if (!route.is_complete) return blame_incomplete_search(graph, route, clock, plan);
  plan.status = Status::unstable;
  plan.reason =
      std::string(graph.is_path() ? "fingers can be placed at every pose, but no sequence of "
                                    "placements keeps the object stable by min_stability = "
                                  : "no route through the lattice keeps the object stable by "
                                    "min_stability = ") +
      figure(graph.options.min_stability) + " N all the way";
  if (!graph.locations.start().empty()) plan.reason += ", from fingers.start on";
  const std::string fault = fault_of_start(graph);
  if (!fault.empty()) {
    plan.status = Status::no_location;
    plan.reason = fault;
  } else {
    graph.is_path() ? blame_geometry_of_path(graph, plan) : blame_geometry_of_lattice(graph, plan);
  }
}

std::optional<Blocked> find_blocked(const Problem& problem, const Options& options) {
  const Locations locations(problem.object, problem.fingers, options);
  const Poses poses =
      std::visit([](const auto& motion) { return needed_poses(motion); }, problem.motion);
  Clearance clearance(problem);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    std::vector<int> clear, chosen;
    for (int i = 0; i < locations.size(); ++i) {
      if (clearance.is_clear(poses[k] * locations[i].center_O)) clear.push_back(i);
    }
    if (fit(locations, clear, 0, problem.fingers.count, chosen)) continue;
    std::ostringstream reason;
    reason << "at pose " << k << " of " << poses.size() << " ";
    if (clear.empty()) {
      reason << "no fingertip location is clear";
    } else {
      reason << "only " << clear.size() << " fingertip locations are clear, with no place for "
             << problem.fingers.count << " fingers apart";
    }
    reason << ": of " << locations.size() << " locations "
           << in_the_way(problem, locations, poses[k]);
    return Blocked{clear.empty() ? "reach of the lattice" : "geometry", reason.str()};
  }
  return std::nullopt;
}

}  // namespace graspless::fingertip
