// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "graspless/fingertip/fingertip.hpp"
#include "graspless/mechanics/friction_interval.hpp"

#include "fingertip/model/evaluator.hpp"
#include "fingertip/model/instants.hpp"
#include "fingertip/model/locations.hpp"
#include "fingertip/model/pose_graph.hpp"

namespace graspless::fingertip {

/// Tables that all searches of a problem share: fingertip locations, the instants met so far, and
/// an evaluator for each thread. Problem and options must outlive it.
struct SearchContext {
  SearchContext(const Problem& problem, const Options& options);

  const Problem& problem;
  const Options& options;
  Locations locations;
  Instants instants;
  std::vector<Evaluator> evaluators;
};

/// Searches a graph by the engine of the options. Routes of `limit` or more are not searched for,
/// in a path. With `needs_regrasp`, it is known that there is none without a regrasp.
Route search(const PoseGraph& graph, SearchContext& context, planning::Clock& clock,
             Statistics& statistics, double limit = std::numeric_limits<double>::infinity(),
             bool needs_regrasp = false);

/// Throws std::invalid_argument that names the pose or the axis unless the motion is one.
void check_motion(const Problem& problem);

/// plan() without validation and explanation.
Plan solve(const Problem& problem, const Options& options, planning::Clock& clock);

/// Empty, or what to take less of: the search would need more than options.max_memory.
std::string lack_of_memory(const Problem& problem, const Options& options);

/// Adds the evaluators' counters to the statistics, and the time.
void count(const SearchContext& context, const planning::Clock& clock, Statistics& statistics);

// failure.cpp, explain.cpp

/// Fills status and reason of a plan that was not found because the clock is out.
void blame_clock(const planning::Clock& clock, Plan& plan);

/// Fills status and reason of a plan that was not found: geometry, stability or time.
void explain_failure(const PoseGraph& graph, const Route& route, planning::Clock& clock,
                     Plan& plan);

/// A pose that the object must take and at which the fingers find no place.
struct Blocked {
  std::string limit;   ///< reach of the lattice: no location is clear; geometry: too few, apart
  std::string reason;  ///< which pose, and what is in the way
};

/// The first such pose of the motion: any pose of a path, else start or goal.
std::optional<Blocked> find_blocked(const Problem& problem, const Options& options);

/// Explains why no plan was found: which limit blocks (`limit`, and where in `reason`) and the
/// smallest single changes that make the problem solvable (`relaxations`). Plans anew with other
/// values in the time that the clock has left. Changes with which one regrasp is enough come first,
/// since more regrasps take long to exclude. If time runs out meanwhile, the changes found help but
/// may not be the smallest. The same failure with enough time gives the same answer.
void explain(const Problem& problem, const Options& options, planning::Clock& clock, Plan& plan);

// assemble.cpp

/// The fingers stay on the object while it passes through these poses: one pose or more. From one
/// stage to the next the object stays where it is and one finger moves.
struct Stage {
  Placement placement;
  std::vector<Eigen::Isometry3d> X_WO;
};

/// A route of the manipulation-feasibility graph as stages.
std::vector<Stage> stages_of(const PoseGraph& graph, const Route& route);

/// Fills a plan's segments, rows, cost, weakest row, regrasps and warnings. The cost is computed
/// anew by (9) and (10). A stage that carries the object along different ways (slide, turn, tumble)
/// becomes several segments.
void assemble(const std::vector<Stage>& stages, const Locations& locations, Instants& instants,
              Evaluator& evaluator, Plan& plan);

/// Fills a plan from the stages that a search found. If the time is over, this still takes time in
/// proportion to the rows (planning::Clock::conclude).
void write_up(const std::vector<Stage>& stages, SearchContext& context, planning::Clock& clock,
              Plan& plan);

// friction.cpp

/// Place and manner in which a plan fails for a coefficient within the problem's friction
/// intervals.
struct FrictionFailure {
  int segment, row;
  mechanics::FrictionVerdict verdict;
};

/// Examines every distinct instant of a plan with its modes and commanded forces. Empty if all hold
/// for every coefficient. The numbers that `instants` gives tell which instants are distinct.
std::optional<FrictionFailure> find_friction_failure(const Problem& problem, const Options& options,
                                                     Instants& instants, const Plan& plan);

/// Searches until the plan holds for all coefficients in the intervals. While a plan is examined,
/// it is in `plan`. Each coefficient that it fails for is added to those of `instants`, and the
/// search runs anew. If that does not end, the plan is `unstable`, and its reason says that the
/// search gave up and names the last such coefficient: a plan may exist. Where friction is known
/// exactly, this is one search. A plan that was found last may be examined after the time is over,
/// for a time in proportion to its rows.
void plan_over_friction(const Problem& problem, const Options& options, Instants& instants,
                        planning::Clock& clock, const std::function<Plan()>& search, Plan& plan);

}  // namespace graspless::fingertip
