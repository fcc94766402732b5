// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/variants.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "clasp/search/loop_search.hpp"
#include "clasp/search/targets.hpp"
#include "clasp/search/thread_search.hpp"
#include "clasp/stability/load.hpp"

namespace graspless::clasp {
namespace {

/// The search that puts a finger through the hole; null if the arm is not a chain to the palm.
std::unique_ptr<ClaspSearch> thread_search(Query& query, const LoopTask& task,
                                           const Eigen::VectorXd& q_init) {
  try {
    return std::make_unique<ThreadSearch>(query, task, q_init);
  } catch (const std::invalid_argument&) {
    return nullptr;
  }
}

}  // namespace

std::optional<Eigen::VectorXd> opened(Query& query) {
  const Problem& problem = query.problem;
  Eigen::VectorXd q = problem.q_start;
  const Eigen::VectorXd& open = problem.robot.state(problem.hand.open);
  for (const int joint : problem.robot.group(problem.hand.hand)) q[joint] = open[joint];
  if (query.is_motion_free(problem.q_start, q)) return q;
  return std::nullopt;
}

void Variants::add_to(std::vector<std::unique_ptr<ClaspSearch>>& searches, Query& all, Plan& plan) {
  if (std::exchange(are_added_, true)) return;
  const Hand& hand = all.problem.hand;
  std::vector<std::string> pre_shapes{hand.open};
  pre_shapes.insert(pre_shapes.end(), hand.pre_shapes.begin(), hand.pre_shapes.end());
  Problem small = all.problem;
  small.loops.clear();
  for (const int loop : allowed_loops(all.problem)) {
    if (is_small(all.problem, loop, all.width)) small.loops.push_back(loop);
  }
  const auto is_elsewhere = [&](const Eigen::Vector3d& mark) {
    const int loop = marked_loop(all.problem, mark);
    return std::find(small.loops.begin(), small.loops.end(), loop) == small.loops.end();
  };
  auto& marks = small.marks;
  marks.erase(std::remove_if(marks.begin(), marks.end(), is_elsewhere), marks.end());
  if (marks.size() < all.problem.marks.size() && marks.empty()) small.loops.clear();
  for (const std::string& pre_shape : pre_shapes) {
    for (const std::vector<std::string>& fingers : finger_runs(hand)) {
      const bool is_whole = fingers.size() == hand.fingers.size();
      if (is_whole && pre_shape != hand.open)
        add(all.problem, fingers, pre_shape, all, searches, plan);
      else if (!small.loops.empty())
        add(small, fingers, pre_shape, all, searches, plan);
    }
  }
}

void Variants::add(const Problem& problem, const std::vector<std::string>& fingers,
                   const std::string& pre_shape, Query& all,
                   std::vector<std::unique_ptr<ClaspSearch>>& searches, Plan& plan) {
  const Hand& hand = all.problem.hand;
  const bool is_new = pre_shape != hand.open || fingers.size() < hand.fingers.size();
  const bool may_thread = fingers.size() == 1;
  if (!is_new && !may_thread) return;
  const Grip& grip = grips_.emplace_back(problem, all.options, fingers, pre_shape);
  const bool is_whole = fingers.size() == hand.fingers.size();
  if (!is_whole && missing_effort(grip.problem, all.options.stability)) return;
  Query& query = queries_.emplace_back(grip.problem, grip.options, all.clock, all.rng(), all.width);
  const auto open = opened(query);
  if (!open && pre_shape != hand.open) {
    if (is_whole)
      plan.warnings.push_back("pre-shape '" + pre_shape +
                              "' was not tried: the hand cannot move to it from the start without "
                              "collision");
    return;
  }
  const Eigen::VectorXd& q_init = open ? *open : problem.q_start;
  Plan unused;  // for reasons why there is no target
  for (const LoopTask& task : choose_targets(query, q_init, unused)) {
    if (is_new) searches.push_back(std::make_unique<LoopSearch>(query, task, q_init));
    if (!may_thread || !is_small(problem, task.loop, all.width)) continue;
    if (auto search = thread_search(query, task, q_init)) searches.push_back(std::move(search));
  }
}

void Variants::report_to(Query& all) const {
  for (const Query& query : queries_) all.add(query);
}

}  // namespace graspless::clasp
