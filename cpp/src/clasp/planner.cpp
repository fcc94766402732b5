// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner of Section IV: which loops and places to clasp, a task-space RRT for each loop, the
// closing of the fingers, the stability test.
#include "clasp/assemble.hpp"
#include "clasp/search/loop_search.hpp"
#include "clasp/query.hpp"
#include "clasp/search/targets.hpp"

namespace graspless::clasp {
namespace {

/// What there is to say of an object without a hole; it may not even have a surface to touch.
Plan without_hole(const Problem& problem, const planning::Budget& budget) {
  const planning::Clock clock(budget);  // throws on a bad one
  Plan plan;
  plan.status = Status::no_reliable_hole;
  plan.reason = problem.object.loops().reason;
  plan.joint_names = problem.robot.joint_names();
  plan.statistics.seconds = clock.seconds();
  return plan;
}

/// Whether the robot may stand where it stands; else the plan says what touches.
bool is_start_free(Query& query, Plan& plan) {
  const Eigen::VectorXd& q = query.problem.q_start;
  if (query.free.is_free(q)) return true;
  const auto [a, b] = query.free.collision(q);
  plan.status = Status::start_in_collision;
  plan.reason = "at the start, '" + a + "' touches '" + b + "'";
  return false;
}

/// The start with the hand's joints at their open state; the start itself where the hand cannot
/// open.
Eigen::VectorXd opened(Query& query, Plan& plan) {
  const Problem& problem = query.problem;
  Eigen::VectorXd q = problem.q_start;
  const Eigen::VectorXd& open = problem.robot.state(problem.hand.open);
  for (const int joint : problem.robot.group(problem.hand.hand)) q[joint] = open[joint];
  if (query.is_motion_free(problem.q_start, q)) return q;
  plan.warnings.push_back(
      "the hand touches something while it opens at the start, and stays as "
      "it is");
  return problem.q_start;
}

Status failure(const Query& query) {
  if (query.clock.was_interrupted()) return Status::interrupted;
  return query.statistics.refusals.count("clasp: not secure") ? Status::not_secure
                                                              : Status::not_found;
}

}  // namespace

Plan plan(const Problem& problem, const Options& options, const planning::Budget& budget) {
  validate(problem);
  validate(options);
  if (problem.object.loops().loops.empty()) return without_hole(problem, budget);
  Query query(problem, options, budget);
  Plan plan;
  plan.joint_names = problem.robot.joint_names();
  std::vector<std::unique_ptr<LoopSearch>> searches;
  if (is_start_free(query, plan)) {
    const Eigen::VectorXd q_init = opened(query, plan);
    for (const LoopTargets& of : choose_targets(query, q_init, plan)) {  // IV-A: S and G_gamma
      searches.push_back(std::make_unique<LoopSearch>(query, of, q_init));
    }
  }
  for (std::size_t turn = 0; !plan && !searches.empty() && query.clock.spend(); ++turn) {
    LoopSearch& search = *searches[turn % searches.size()];
    while (!plan && search.cycle()) {                               // IV-D: Algorithm 1
      std::optional<Found> found = close_clasp(query, search);      // IV-D: until contact occurs
      if (found) assemble(query, search, std::move(*found), plan);  // IV-D: path pruning
    }
  }
  if (!plan && !searches.empty()) plan.status = failure(query);
  conclude(query, searches, plan);
  return plan;
}

}  // namespace graspless::clasp
