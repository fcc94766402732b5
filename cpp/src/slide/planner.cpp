// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The integrated planner of Section IV-C: ForestCBiRRT (Algorithm 1) over the arm's joints, with
// C_s of Eq. (3), C_g of Eq. (4), the relaxed contact constraint, and IsPairValid.
#include <ompl/base/ScopedState.h>

#include "graspless/planning/vector_states.hpp"
#include "graspless/slide/resume.hpp"

#include "planning/plan_within.hpp"
#include "slide/assemble.hpp"
#include "slide/interruption.hpp"
#include "slide/motions.hpp"
#include "slide/query.hpp"
#include "slide/refusals.hpp"
#include "slide/search.hpp"

namespace graspless::slide {

namespace ob = ompl::base;
using planning::Path;

namespace {

constexpr int kShortcutRounds = 30;

/// True if a path is much longer than the straight line between its ends: it came from a tree.
bool is_detour(const Path& path) {
  return planning::length(path) > 1.2 * (path.back() - path.front()).norm();
}

/// Shortens the slide along motions that keep the contact constraint.
Path shortened(Query& query, Path path) {
  const ContactSpace::Carried carried = query.carried_from(path.front());
  const planning::Connect connect = [&](const Eigen::VectorXd& from,
                                        const Eigen::VectorXd& to) -> std::optional<Path> {
    if (query.clock.is_out()) return std::nullopt;
    return query.contact.connect(from, to, carried);
  };
  return planning::shortcut(std::move(path), connect, kShortcutRounds, query.rng);
}

Status status_of(const Query& query, const planning::ForestCBiRRT& planner) {
  if (query.clock.was_interrupted()) return Status::interrupted;
  if (planner.num_start_roots() == 0) return Status::no_start_root;
  if (planner.num_goal_roots() == 0) return Status::no_goal_root;
  return planner.num_pairs() > 0 ? Status::no_valid_pair : Status::not_connected;
}

void fill_statistics(const planning::ForestCBiRRT& planner, Query& query, Statistics& statistics) {
  statistics = query.statistics;
  statistics.seconds = query.clock.seconds();
  statistics.iterations = query.clock.iterations();
  statistics.nodes = static_cast<std::int64_t>(planner.num_nodes());
  statistics.start_roots = static_cast<std::int64_t>(planner.num_start_roots());
  statistics.goal_roots = static_cast<std::int64_t>(planner.num_goal_roots());
  statistics.collision_checks = query.contact.num_checks() + query.free.world().num_checks();
  statistics.projections = query.contact.num_projections();
}

/// Algorithm 1 from the starts of `search` to a valid pair, and the plan's segments.
void solve(Query& query, const Motions& motions, const SlideSearch& search, Plan& plan) {
  ob::PlannerStatus status = ob::PlannerStatus::TIMEOUT;
  query.clock.run([&] {  // where a step outlasts the clock, what was found until then counts
    status = search.planner->solve(  // Algorithm 1
        ob::PlannerTerminationCondition([&] { return !query.clock.spend(); }));
  });
  if (status == ob::PlannerStatus::EXACT_SOLUTION) {
    Path slide = planning::to_path(search.problem->getSolutionPath(), query.arm.dof());
    query.clock.run([&] {  // the slide is kept as it is where the time ends
      if (is_detour(slide)) query.is_lag_small(slid_along(query, shortened(query, slide)));
    });
    Plan whole = plan;  // of the shortened one, if its lag is small
    if (query.clock.conclude([&] { assemble(query, motions, query.slid, whole); })) plan = whole;
  }
  if (!plan) plan.status = status_of(query, *search.planner);
  fill_statistics(*search.planner, query, plan.statistics);
  plan.reason = reason(query, plan);
}

Plan searched(Query& query) {
  Plan plan;
  if (!is_home_free(query, plan) || !can_press(query, plan) || !can_reach(query, plan) ||
      !can_drag(query, plan) || !can_be_left(query, plan))
    return plan;
  Motions motions(query);  // IsPairValid(), Section IV-C.1
  const ob::SpaceInformationPtr si = make_space(query);
  const auto starts = std::make_shared<StartRegion>(si, query);         // C_s, Eq. (3)
  const auto goals = std::make_shared<GoalRegion>(si, query, motions);  // C_g, Eq. (4)
  solve(query, motions, make_search(query, si, starts, goals), plan);   // Section IV-C.3
  return plan;
}

/// The same from a single start, at which the finger presses already.
Plan searched_from(Query& query, const Interruption& at) {
  Plan plan;
  plan.resumed = at;
  if (!can_be_left(query, plan)) return plan;
  const std::optional<Eigen::VectorXd> start = find_pressed_start(query, at, plan);
  if (!start) return plan;
  query.refuses_lag = false;
  Motions motions(query);
  motions.begin_at(*start);
  const ob::SpaceInformationPtr si = make_space(query);
  const auto goals = std::make_shared<GoalRegion>(si, query, motions, &at);
  const SlideSearch search = make_search(query, si, nullptr, goals);
  ob::ScopedState<ob::RealVectorStateSpace> root(si);
  planning::vector(root.get(), query.arm.dof()) = *start;
  search.problem->addStartState(root);
  solve(query, motions, search, plan);
  return plan;
}

/// The whole plan anew, after the finger has been lifted off.
Plan searched_anew(Query& query, const Interruption& at) {
  Plan plan;
  const std::optional<Retreat> retreat = find_retreat(query, at, plan);
  if (!retreat) return plan;
  Problem now = query.problem;
  now.q_home = query.arm.full(retreat->path.back());
  now.X_WO_start = query.X_WS * spatial(retreat->object_S);
  Query anew(now, query.options, query.clock, query.rng());
  plan = searched(anew);
  if (plan) prepend_retreat(query, *retreat, plan);
  return plan;
}

/// Runs `search` on a query within the budget.
template <class Search>
Plan within_budget(const Problem& problem, const Options& options, const planning::Budget& budget,
                   const Search& search) {
  planning::Clock clock(budget, options.max_memory);
  Plan plan = planning::plan_within(
      clock, "a larger options.range, or shapes and outlines of fewer corners", [&] {
        validate(problem, options);
        Query query(problem, options, clock, budget.seed);
        return search(query);
      });
  plan.statistics.iterations = clock.iterations();
  plan.joint_names = problem.robot.joint_names();
  return plan;
}

/// The same for a search that goes on from an interruption.
template <class Search>
Plan within_budget(const Problem& problem, const Interruption& at, const Options& options,
                   const planning::Budget& budget, const Search& search) {
  validate(problem, at);
  Plan plan =
      within_budget(problem, options, budget, [&](Query& query) { return search(query, at); });
  plan.resumed = at;
  return plan;
}

}  // namespace

Plan plan(const Problem& problem, const Options& options, const planning::Budget& budget) {
  return within_budget(problem, options, budget, searched);
}

Plan resume(const Problem& problem, const Interruption& at, const Options& options,
            const planning::Budget& budget) {
  return within_budget(problem, at, options, budget, searched_from);
}

Plan restart(const Problem& problem, const Interruption& at, const Options& options,
             const planning::Budget& budget) {
  return within_budget(problem, at, options, budget, searched_anew);
}

}  // namespace graspless::slide
