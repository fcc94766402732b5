// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner of Stork 2013, Section IV: selects loops and targets, grows a task-space RRT per
// loop, closes the fingers, and tests the stability. Margins name the paper's sections.
#include <algorithm>
#include <cmath>

#include "clasp/assemble.hpp"
#include "clasp/grip.hpp"
#include "clasp/query.hpp"
#include "clasp/search/hole.hpp"
#include "clasp/search/loop_search.hpp"
#include "clasp/search/reachability.hpp"
#include "clasp/search/targets.hpp"
#include "clasp/stability/load.hpp"
#include "clasp/variants.hpp"
#include "planning/obstruction.hpp"
#include "planning/plan_within.hpp"
#include "text.hpp"

namespace graspless::clasp {
namespace {

constexpr const char* kStaysClosed =
    "the hand touches something while it opens at the start, and stays as it is";

/// Plan for an object without a hole. Such an object may not even have a surface.
Plan without_hole(const Problem& problem, const planning::Clock& clock) {
  Plan plan;
  plan.status = Status::no_reliable_hole;
  plan.reason = problem.object.loops().reason;
  plan.statistics.seconds = clock.seconds();
  return plan;
}

/// True if the start configuration is collision-free. If not, sets status and reason of the plan.
bool is_start_free(Query& query, Plan& plan) {
  const Eigen::VectorXd& q = query.problem.q_start;
  if (query.free.is_free(q)) return true;
  const auto [a, b] = query.free.collision(q);
  plan.status = Status::start_in_collision;
  plan.reason = "at the start, " + planning::contact(a, b);
  return false;
}

/// Warns of joints of the hand whose strength is unknown.
void warn_of_missing_limits(const Problem& problem, const Options& options, Plan& plan) {
  if (options.stability.force == 0) return;
  for (const int joint : problem.robot.group(problem.hand.hand)) {
    if (std::isfinite(problem.robot.max_effort()[joint])) continue;
    plan.warnings.push_back("joint '" + problem.robot.joint_names()[joint] +
                            "' of the hand has no effort limit above 0 in the URDF; what the "
                            "motors withstand is computed as if it never gave way");
  }
}

Status failure(const Query& query) {
  if (query.clock.was_interrupted()) return Status::interrupted;
  const auto refused = [&](const char* why) { return query.statistics.refusals.count(why) > 0; };
  return refused(kNotSecure) || refused(kForcedOpen) ? Status::not_secure : Status::not_found;
}

constexpr std::size_t kLoopsTold = 3;  // whose sizes a reason names

/// Adds to the reason of a failed search what the arm reaches and what sizes stand in the way, if
/// the clock leaves time for it.
void explain_failure(const Problem& problem, planning::Clock& clock, Plan& plan) {
  const bool failed = plan.status == Status::not_found || plan.status == Status::not_secure;
  if (!failed || plan.statistics.cycles == 0) return;
  clock.run([&] {
    std::vector<int> loops = allowed_loops(problem);
    loops.resize(std::min<std::size_t>(loops.size(), kLoopsTold));
    for (const int loop : loops) plan.reason += "; " + describe_sizes(problem, loop);
  });
  clock.run([&] {
    const std::string reach = describe_reach(problem);
    if (!reach.empty()) plan.reason += "; " + reach;
  });
}

/// Adds the certificate of the clasp, if the clock leaves time for it.
void certify(const Problem& problem, const Options& options, planning::Clock& clock, Plan& plan) {
  if (!plan) return;
  const double before = clock.seconds();
  clock.run([&] {
    plan.certificate =
        certificate(Grip(problem, options, plan.fingers, plan.pre_shape).problem,
                    plan.segments.back().positions.back(), plan.loop, options.certificate);
  });
  if (!plan.certificate)
    plan.warnings.push_back("no time was left for the certificate of the clasp");
  plan.statistics.certificate_seconds = clock.seconds() - before;
  plan.statistics.seconds = clock.seconds();
}

void warn_of_gap(const Problem& problem, Plan& plan) {
  const double gap = problem.object.loops().found[plan.loop].gap;
  if (gap == 0) return;
  plan.warnings.push_back("the clasped loop crosses a gap of " + figure(gap, 3) +
                          " m without points; the object may come free there");
}

Plan searched(const Problem& problem, const Options& options, planning::Clock& clock,
              std::uint64_t seed) {
  validate(problem);
  validate(options);
  require_efforts(problem, options.stability);
  if (problem.object.loops().found.empty()) return without_hole(problem, clock);
  Query query(problem, options, clock, seed, hand_width(problem));
  Plan plan;
  warn_of_missing_limits(problem, options, plan);
  Variants variants;
  std::vector<std::unique_ptr<ClaspSearch>> searches;
  const bool is_free = is_start_free(query, plan);
  if (is_free) {
    const auto open = opened(query);
    if (!open) plan.warnings.push_back(kStaysClosed);
    const Eigen::VectorXd& q_init = open ? *open : problem.q_start;
    for (const LoopTask& task : choose_targets(query, q_init, plan)) {  // IV-A: S and G_gamma
      searches.push_back(std::make_unique<LoopSearch>(query, task, q_init));
    }
  }
  if (is_free && searches.empty()) {
    variants.add_to(searches, query, plan);
    if (!searches.empty()) plan.reason.clear();
  }
  if (!searches.empty()) problem.object.outer_clearance();  // now: a failed search has no time left
  const std::size_t patience = Variants::kPatience * searches.size();
  clock.run([&] {
    for (std::size_t turn = 0; !plan && !searches.empty() && query.clock.spend(); ++turn) {
      if (turn == patience) variants.add_to(searches, query, plan);
      ClaspSearch& search = *searches[turn % searches.size()];
      while (!plan && search.cycle()) {                    // IV-D: Algorithm 1
        std::optional<Clasp> clasp = close_clasp(search);  // IV-D: until contact occurs
        if (!clasp) continue;
        Plan whole = plan;
        const bool is_whole =  // IV-D: path pruning
            clock.conclude([&] { assemble(search, std::move(*clasp), whole); });
        if (is_whole) plan = std::move(whole);
      }
    }
  });  // counters and reason stay if the time ends in the middle of a test
  variants.report_to(query);
  if (plan) warn_of_gap(problem, plan);
  if (!plan && !searches.empty()) plan.status = failure(query);
  conclude(query, searches, plan);
  return plan;
}

}  // namespace

Plan plan(const Problem& problem, const Options& options, const planning::Budget& budget) {
  planning::Clock clock(budget, options.max_memory);
  Plan plan = planning::plan_within(clock, "fewer points or options.targets",
                                    [&] { return searched(problem, options, clock, budget.seed); });
  plan.joint_names = problem.robot.joint_names();
  explain_failure(problem, clock, plan);
  certify(problem, options, clock, plan);
  return plan;
}

}  // namespace graspless::clasp
