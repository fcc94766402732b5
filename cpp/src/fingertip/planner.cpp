// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner of Section 4: the lattice of locations, the instants of the motion, the search of the
// manipulation-feasibility graph, and the plan.
#include "fingertip/planner.hpp"

#include <algorithm>
#include <sstream>

#include "fingertip/assemble.hpp"
#include "fingertip/explain.hpp"
#include "fingertip/friction.hpp"
#include "fingertip/motions.hpp"

namespace graspless::fingertip {
namespace {

Plan plan_path(Workshop& workshop, const Path& path, planning::Clock& clock) {
  Plan plan;
  const PathQuery query(workshop.problem, path, workshop.locations, workshop.instants,
                        workshop.options);
  const Route route = search(query, workshop, clock, plan.statistics);
  if (route.found) {
    assemble(stages_of(query, route), workshop.locations, workshop.instants,
             workshop.evaluators.front(), plan);
    plan.status = Status::solved;
    plan.lower_bound = route.is_complete ? plan.cost : route.lower_bound;
  } else {
    plan.lower_bound = route.lower_bound;
    explain_failure(query, route, clock, plan);
  }
  return plan;
}

/// What was found, in a sentence.
std::string summary(const Plan& plan) {
  const Row& weakest = plan.segments[static_cast<std::size_t>(plan.weakest_segment)]
                           .rows[static_cast<std::size_t>(plan.weakest_row)];
  std::ostringstream text;
  text << plan.segments.size() << (plan.segments.size() == 1 ? " segment" : " segments") << " with "
       << plan.regrasps << (plan.regrasps == 1 ? " regrasp" : " regrasps")
       << "; the weakest row withstands " << weakest.stability << " N";
  return text.str();
}

}  // namespace

Workshop::Workshop(const Problem& problem_in, const Options& options_in)
    : problem(problem_in),
      options(options_in),
      locations(problem.object, problem.fingers, options),
      instants(problem, options) {
  for (int i = 0; i < std::max(kLanes, options.threads); ++i) {
    evaluators.emplace_back(instants, locations, options);
  }
}

Route search(const PathQuery& query, Workshop& workshop, planning::Clock& clock,
             Statistics& statistics, double limit) {
  if (workshop.options.search == Search::fast) {
    return search_fast(query, workshop.evaluators, clock, statistics, limit);
  }
  return search_graph(query, workshop.evaluators.front(), workshop.options.search == Search::paper,
                      clock, statistics, limit);
}

void count(const Workshop& workshop, const planning::Clock& clock, Statistics& statistics) {
  statistics.seconds = clock.seconds();
  statistics.locations = workshop.locations.size();
  for (const Evaluator& evaluator : workshop.evaluators) {
    const auto& counters = evaluator.solver().counters();
    statistics.z_evaluations += counters.evaluations;
    statistics.bounded_tests += counters.bounded_tests;
    statistics.pivots += counters.pivots;
  }
}

Plan solve(const Problem& problem, const Options& options, planning::Clock& clock) {
  Workshop workshop(problem, options);
  Plan plan = plan_over_friction(problem, options, workshop.instants, [&] {
    for (Evaluator& evaluator : workshop.evaluators) evaluator.forget();
    if (const auto* path = std::get_if<Path>(&problem.motion)) {
      return plan_path(workshop, *path, clock);
    }
    if (const auto* goal = std::get_if<Goal>(&problem.motion)) {
      return plan_goal(workshop, *goal, clock);
    }
    return plan_lattice(workshop, std::get<Lattice>(problem.motion), clock);
  });
  if (plan) plan.reason = summary(plan);
  count(workshop, clock, plan.statistics);
  return plan;
}

Plan plan(const Problem& problem, const Options& options, const planning::Budget& budget) {
  planning::Clock clock(budget);
  validate(problem, options);
  Plan plan = solve(problem, options, clock);
  if (options.explain) explain(problem, options, clock, plan);
  plan.statistics.seconds = clock.seconds();
  return plan;
}

}  // namespace graspless::fingertip
