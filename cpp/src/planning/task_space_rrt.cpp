// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/task_space_rrt.hpp"

#include <algorithm>
#include <utility>

#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include "planning/task_space_tree.hpp"

namespace graspless::planning {

namespace ob = ompl::base;

namespace {

constexpr int kStall = 12;  // control steps without progress that end a connection

double unit_draw(std::mt19937_64& rng) { return std::uniform_real_distribution<double>(0, 1)(rng); }

}  // namespace

// Algorithm 1, BUILD-TS-RRT.
ob::PlannerStatus TaskSpaceRRT::solve(const Termination& ptc) {
  check_setup();
  if (!isSetup()) setup();
  if (!read_starts()) return ob::PlannerStatus::INVALID_START;
  if (!tree_) start_tree(ptc);  // 1, 2
  if (starts_at_goal()) return ob::PlannerStatus::EXACT_SOLUTION;
  for (std::int64_t k = 0; k < max_iterations_ && !ptc; ++k) {  // 3
    if (next_target_ == 0) {
      if (is_exhausted()) start_tree(ptc);
      ++num_cycles_;
      ++tree_->cycles;
      if (unit_draw(rng_) < random_probability_) {  // 4
        random_task_(rng_, x_rand_);                // 5
        ts_extend(x_rand_);                         // 6
        continue;
      }
    }
    for (std::size_t g = std::exchange(next_target_, 0); g < targets_.size() && !ptc;
         ++g) {                                // 8, 9
      if (!ts_connect_goal(g, ptc)) continue;  // 10
      next_target_ = g + 1;
      return ob::PlannerStatus::EXACT_SOLUTION;
    }
  }
  return ob::PlannerStatus::TIMEOUT;
}

// Starts a new tree with its random extensions.
void TaskSpaceRRT::start_tree(const Termination& ptc) {
  if (tree_) ++num_restarts_;
  next_target_ = 0;
  reached_node_ = -1;
  const Eigen::Index dim = targets_[0].size();
  tree_ = std::make_unique<Tree>(si_, weights_.size() > 0 ? weights_ : Eigen::VectorXd::Ones(dim),
                                 targets_.size());
  for (const State* start : starts_) {
    project_(start, x_new_);
    tree_->add_root(start, x_new_);
    ++num_grown_;
  }
  const auto last = static_cast<std::int64_t>(pre_expansions_.size()) - 1;
  const int n = pre_expansions_[std::min(num_restarts_, last)];
  for (int i = 0; i < n && !ptc; ++i) {
    random_task_(rng_, x_rand_);
    ts_extend(x_rand_);
  }
}

bool TaskSpaceRRT::is_exhausted() const {
  return restart_cycles_ > 0 && tree_->cycles >= restart_cycles_;
}

// Algorithm 2, TS-EXTEND.
bool TaskSpaceRRT::ts_extend(const Eigen::VectorXd& x) {
  const int near = tree_->nearest(x);  // 1
  return step(near, x, true) >= 0;     // 2 - 6
}

// Algorithm 3, TS-CONNECT-GOAL. Also ends on a stall, without progress, and after too many steps.
bool TaskSpaceRRT::ts_connect_goal(std::size_t target, const Termination& ptc) {
  const Eigen::VectorXd& x = targets_[target];
  int near = tree_->nearest_unextended(x, target);  // 1
  if (near < 0) return false;
  double least = tree_->distance(near, x);
  int steps_without_progress = 0;
  for (int i = 0; i < max_connect_steps_ && steps_without_progress < kStall && !ptc; ++i) {  // 2
    tree_->mark_extended(near, target);
    const int node = step(near, x, false);  // 3 - 6
    if (node < 0) return false;             // 12
    if (is_reached(node, target)) {         // 7
      accept(node, target);                 // 8
      return true;
    }
    const double left = tree_->distance(node, x);
    steps_without_progress = left < least ? 0 : steps_without_progress + 1;
    least = std::min(least, left);
    near = node;  // 10
  }
  if (steps_without_progress >= kStall) tree_->mark_extended(near, target);
  return false;
}

// Takes one control step and returns the new node (lines 2 to 6 of Algorithm 2, 3 to 6 of Algorithm
// 3), or -1 if the controller stalls or the motion is not free.
int TaskSpaceRRT::step(int near, const Eigen::VectorXd& x, bool is_exploring) {
  ++num_steps_;
  const State* q_near = tree_->state(near);
  if (!control_(q_near, tree_->x(near), x, is_exploring, q_new_)) return -1;
  project_(q_new_, x_new_);
  if (!x_new_.allFinite() || !si_->satisfiesBounds(q_new_)) return -1;
  if (!si_->checkMotion(q_near, q_new_)) return -1;  // COLLISION-FREE
  ++num_grown_;
  return tree_->add(q_new_, x_new_, near);
}

bool TaskSpaceRRT::is_reached(int node, std::size_t target) {
  if (tolerance_) return tolerance_(targets_[target], tree_->x(node));
  return pdef_->getGoal()->isSatisfied(tree_->state(node));
}

bool TaskSpaceRRT::starts_at_goal() {
  if (has_tried_starts_ || pdef_->hasSolution()) return false;
  has_tried_starts_ = true;
  for (int root = 0; root < static_cast<int>(starts_.size()); ++root) {
    for (std::size_t g = 0; g < targets_.size(); ++g) {
      if (!is_reached(root, g)) continue;
      accept(root, g);
      return true;
    }
  }
  return false;
}

// TERMINATE-SEARCH: the node and its ancestors are the solution.
void TaskSpaceRRT::accept(int node, std::size_t target) {
  reached_target_ = static_cast<int>(target);
  reached_node_ = node;
  tree_->mark_extended(node);
  std::vector<int> branch{node};
  while (tree_->parent(branch.back()) != branch.back())
    branch.push_back(tree_->parent(branch.back()));
  auto path = std::make_shared<ompl::geometric::PathGeometric>(si_);
  for (auto i = branch.rbegin(); i != branch.rend(); ++i) path->append(tree_->state(*i));
  pdef_->addSolutionPath(path, false, 0.0, getName());
}

}  // namespace graspless::planning
