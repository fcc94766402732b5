// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner of Section 4: the lattice of locations, the instants of the motion, the search of the
// manipulation-feasibility graph, and the plan.
#include "fingertip/planner.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "fingertip/goal/goal.hpp"
#include "fingertip/lattice/search.hpp"
#include "fingertip/lazy/search.hpp"
#include "fingertip/search/graph_search.hpp"

namespace graspless::fingertip {
namespace {

template <typename Motion>
Plan plan_graph(SearchContext& context, const Motion& motion, planning::Clock& clock) {
  Plan plan;
  const PoseGraph graph(context.problem, motion, context.locations, context.instants,
                        context.options);
  const Route route = search(graph, context, clock, plan.statistics);
  plan.lower_bound = route.lower_bound;
  if (route.found) {
    write_up(stages_of(graph, route), context, clock, plan);
    if (plan && route.is_complete) plan.lower_bound = plan.cost;
  } else {
    explain_failure(graph, route, clock, plan);
  }
  return plan;
}

/// One sentence on the plan found.
std::string summary(const Plan& plan) {
  const Row& weakest = plan.segments[plan.weakest_segment].rows[plan.weakest_row];
  std::ostringstream text;
  text << plan.segments.size() << (plan.segments.size() == 1 ? " segment" : " segments") << " with "
       << plan.regrasps << (plan.regrasps == 1 ? " regrasp" : " regrasps")
       << "; the stability is at least " << weakest.stability << " N, and every row withstands "
       << plan.withstands << " N";
  return text.str();
}

}  // namespace

SearchContext::SearchContext(const Problem& problem_in, const Options& options_in)
    : problem(problem_in),
      options(options_in),
      locations(problem.object, problem.fingers, options),
      instants(problem, options) {
  for (int i = 0; i < kPoolSize; ++i) {
    evaluators.emplace_back(instants, locations, options);
  }
}

Route search(const PoseGraph& graph, SearchContext& context, planning::Clock& clock,
             Statistics& statistics, double limit, bool needs_regrasp) {
  Evaluator& evaluator = context.evaluators.front();
  if (context.options.search != Search::fast) {
    GraphSearch settings;
    settings.heuristic = context.options.search == Search::paper;
    settings.limit = limit;
    return search_graph(graph, evaluator, settings, clock, statistics);
  }
  return graph.is_path()
             ? search_fast(graph, context.evaluators, clock, statistics, limit, needs_regrasp)
             : search_lattice(graph, evaluator, clock, statistics);
}

void count(const SearchContext& context, const planning::Clock& clock, Statistics& statistics) {
  statistics.seconds = clock.seconds();
  statistics.locations = context.locations.size();
  for (const Evaluator& evaluator : context.evaluators) {
    const auto& counters = evaluator.solver().counters();
    statistics.z_evaluations += counters.evaluations;
    statistics.bounded_tests += counters.bounded_tests;
    statistics.pivots += counters.pivots;
    statistics.ill_conditioned += counters.handed_over;
  }
}

void write_up(const std::vector<Stage>& stages, SearchContext& context, planning::Clock& clock,
              Plan& plan) {
  Plan whole = plan;
  std::size_t rows = stages.size();  // one for each regrasp
  for (const Stage& stage : stages) {
    rows += stage.X_WO.size() * static_cast<std::size_t>(context.options.samples_per_arc);
  }
  const auto write = [&] {
    assemble(stages, context.locations, context.instants, context.evaluators.front(), whole);
  };
  if (!clock.conclude(write, rows)) {
    blame_clock(clock, plan);
    if (plan.status == Status::out_of_time)
      plan.reason = "a plan was found, but the time was over before it was written up";
    return;
  }
  plan = std::move(whole);
  plan.status = Status::solved;
}

Plan solve(const Problem& problem, const Options& options, planning::Clock& clock) {
  Plan refused;
  refused.reason = lack_of_memory(problem, options);
  refused.status = Status::out_of_memory;
  if (!refused.reason.empty()) return refused;
  SearchContext context(problem, options);
  const auto search = [&] {
    for (Evaluator& evaluator : context.evaluators) evaluator.forget();
    if (const auto* path = std::get_if<Path>(&problem.motion)) {
      return plan_graph(context, *path, clock);
    }
    if (const auto* goal = std::get_if<Goal>(&problem.motion)) {
      return plan_goal(context, *goal, clock);
    }
    return plan_graph(context, std::get<Lattice>(problem.motion), clock);
  };
  Plan plan;
  const bool has_ended = clock.run(
      [&] { plan_over_friction(problem, options, context.instants, clock, search, plan); });
  if (!has_ended) {  // the bound also holds with friction anywhere in its interval
    const double lower_bound = plan.lower_bound;
    plan = Plan();
    plan.lower_bound = lower_bound;
    blame_clock(clock, plan);
  }
  if (plan) plan.reason = summary(plan);
  count(context, clock, plan.statistics);
  return plan;
}

Plan plan(const Problem& problem, const Options& options, const planning::Budget& budget) {
  planning::Clock clock(budget, options.max_memory);
  Plan plan;
  const bool has_ended = clock.run([&] {
    validate(problem, options);
    plan = solve(problem, options, clock);
  });
  if (!has_ended) blame_clock(clock, plan);
  if (has_ended && options.explain) {
    Plan explained = plan;
    if (clock.run([&] { explain(problem, options, clock, explained); })) plan = explained;
  }
  plan.statistics.seconds = clock.seconds();
  return plan;
}

}  // namespace graspless::fingertip
