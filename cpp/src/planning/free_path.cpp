// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/free_path.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>

#include "graspless/planning/forest_cbirrt.hpp"
#include "graspless/planning/vector_states.hpp"

#include "planning/grow_path.hpp"

namespace graspless::planning {

namespace ob = ompl::base;

namespace {

constexpr double kRange =
    0.6;  // longest extension [rad]; the motion check covers the points between its ends
constexpr int kShortcuts = 40;

/// Cuts the ranges of joints that can turn further than once to half a turn beyond both ends.
FreeSpace without_turns(FreeSpace space, const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  for (Eigen::Index i = 0; i < from.size(); ++i) {
    double &lower = space.lower[i], &upper = space.upper[i];
    if (upper - lower <= 2 * M_PI) continue;
    lower = std::max(lower, std::min(from[i], to[i]) - M_PI);
    upper = std::min(upper, std::max(from[i], to[i]) + M_PI);
  }
  return space;
}

}  // namespace

std::optional<Path> grow_path(const FreeSpace& space, const Eigen::VectorXd& from,
                              const Eigen::VectorXd& to, double range, const Projection& project,
                              int iterations, std::mt19937_64& rng) {
  const Eigen::Index n = from.size();
  const auto box = make_box(space.lower, space.upper);
  const auto si = std::make_shared<ob::SpaceInformation>(box);
  // The ends are free. Near a clearance, a second test may fail: its proof begins elsewhere.
  si->setStateValidityChecker([&](const ob::State* s) {
    return vector(s, n) == from || vector(s, n) == to || space.is_free(vector(s, n));
  });
  si->setup();
  const auto problem = std::make_shared<ob::ProblemDefinition>(si);
  ob::ScopedState<ob::RealVectorStateSpace> start(box), goal(box);
  vector(start.get(), n) = from;
  vector(goal.get(), n) = to;
  problem->setStartAndGoalStates(start, goal);

  ForestCBiRRT planner(si);
  planner.setProblemDefinition(problem);
  planner.set_range(range);
  planner.set_seed(rng());
  planner.set_random_config(
      [&](std::mt19937_64& g, ob::State* s) { draw_uniform(g, space.lower, space.upper, s); });
  if (project) {
    planner.set_projector([&](ob::State* s) {
      Eigen::VectorXd q = vector(s, n);
      if (!project(q)) return false;
      vector(s, n) = q;
      return true;
    });
  }
  planner.set_motion_check([&](const ob::State*, const ob::State* a, const ob::State* b) {
    return space.is_motion_free(vector(a, n), vector(b, n));
  });
  int left = iterations;
  if (!planner.solve(
          ob::PlannerTerminationCondition([&] { return left-- <= 0 || space.is_out(); }))) {
    return std::nullopt;
  }
  return to_path(problem->getSolutionPath(), n);
}

std::optional<Path> find_free_path(const FreeSpace& space, const Eigen::VectorXd& from,
                                   const Eigen::VectorXd& to, int iterations,
                                   std::mt19937_64& rng) {
  if (from.size() != to.size()) throw std::invalid_argument("from and to must have one size");
  if (space.is_motion_free(from, to)) return Path{from, to};
  if (iterations <= 0 || !space.is_free(from) || !space.is_free(to)) return std::nullopt;
  const auto path =
      grow_path(without_turns(space, from, to), from, to, kRange, {}, iterations, rng);
  if (!path) return std::nullopt;
  const Connect straight = [&](const Eigen::VectorXd& a,
                               const Eigen::VectorXd& b) -> std::optional<Path> {
    if (!space.is_motion_free(a, b)) return std::nullopt;
    return Path{a, b};
  };
  return shortcut(*path, straight, kShortcuts, rng);
}

}  // namespace graspless::planning
