// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// TaskSpaceRRT: OMPL's planner interface except solve(), and checks of the user's set-up.
#include <limits>
#include <stdexcept>
#include <string>

#include <ompl/base/SpaceInformation.h>

#include "graspless/planning/task_space_rrt.hpp"

#include "planning/task_space_tree.hpp"
#include "text.hpp"

namespace graspless::planning {

namespace ob = ompl::base;

namespace {

void require_that(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("TaskSpaceRRT: " + what);
}

}  // namespace

TaskSpaceRRT::TaskSpaceRRT(const ob::SpaceInformationPtr& si)
    : ob::Planner(si, "TaskSpaceRRT"),
      max_iterations_(std::numeric_limits<std::int64_t>::max()),
      q_new_(si->allocState()) {
  specs_.recognizedGoal = ob::GOAL_ANY;
  specs_.directed = true;
  declareParam<double>("random_probability", this, &TaskSpaceRRT::set_random_probability,
                       &TaskSpaceRRT::random_probability, "0.:.05:.95");
  declareParam<int>("pre_expansions", this, &TaskSpaceRRT::set_pre_expansions,
                    &TaskSpaceRRT::pre_expansions, "0:10:1000");
  declareParam<int>("restart_cycles", this, &TaskSpaceRRT::set_restart_cycles,
                    &TaskSpaceRRT::restart_cycles, "0:10:1000");
}

TaskSpaceRRT::~TaskSpaceRRT() {
  clear();
  si_->freeState(q_new_);
}

void TaskSpaceRRT::set_targets(std::vector<Eigen::VectorXd> x) {
  targets_ = std::move(x);
  tree_.reset();
  next_target_ = 0;
  reached_target_ = reached_node_ = -1;
  has_tried_starts_ = false;
}

void TaskSpaceRRT::set_random_probability(double probability) {
  require_that(probability >= 0 && probability < 1,
               "random_probability must lie in [0, 1), not " + figure(probability));
  random_probability_ = probability;
}

void TaskSpaceRRT::set_pre_expansions(int expansions) { set_pre_expansion_schedule({expansions}); }

void TaskSpaceRRT::set_pre_expansion_schedule(std::vector<int> expansions) {
  require_that(!expansions.empty(), "pre_expansions must hold at least one number");
  for (int n : expansions) {
    require_that(n >= 0, "pre_expansions must not be negative, not " + std::to_string(n));
  }
  pre_expansions_ = std::move(expansions);
}

void TaskSpaceRRT::set_max_iterations(std::int64_t cycles) {
  require_that(cycles >= 0, "max_iterations must not be negative, not " + std::to_string(cycles));
  max_iterations_ = cycles;
}

void TaskSpaceRRT::set_restart_cycles(int cycles) {
  require_that(cycles >= 0, "restart_cycles must not be negative, not " + std::to_string(cycles));
  restart_cycles_ = cycles;
}

void TaskSpaceRRT::set_max_connect_steps(int steps) {
  require_that(steps > 0, "max_connect_steps must be positive, not " + std::to_string(steps));
  max_connect_steps_ = steps;
}

// Not in setup(), which SimpleSetup may call before the user has set everything.
void TaskSpaceRRT::check_setup() const {
  require_that(pdef_ != nullptr, "no problem definition set");
  require_that(project_ != nullptr, "set_projection() was not called");
  require_that(control_ != nullptr, "set_controller() was not called");
  require_that(random_task_ != nullptr, "set_random_task() was not called");
  require_that(!targets_.empty(), "set_targets() was not called, or was given no target");
  require_that(tolerance_ || pdef_->getGoal(),
               "needs set_tolerance() or a goal in the problem definition");
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const std::string name = "targets[" + std::to_string(i) + "]";
    require_that(targets_[i].allFinite(), name + " is not finite");
    require_that(targets_[i].size() == targets_[0].size(),
                 name + " has " + std::to_string(targets_[i].size()) + " coordinates, targets[0] " +
                     std::to_string(targets_[0].size()));
  }
}

// Reads new start states, and checks that all task-space vectors have the same size.
bool TaskSpaceRRT::read_starts() {
  while (const State* start = pis_.nextStart()) starts_.push_back(si_->cloneState(start));
  if (starts_.empty()) return false;
  const Eigen::Index n = targets_[0].size();
  const auto require_size = [&](const std::string& name, Eigen::Index size) {
    require_that(size == n, name + " has " + std::to_string(size) + " coordinates, the targets " +
                                std::to_string(n));
  };
  project_(starts_[0], x_new_);
  require_size("the projection", x_new_.size());
  require_that(x_new_.allFinite(), "the projection of the start is not finite");
  if (weights_.size() > 0) {
    require_size("weights", weights_.size());
    require_that(weights_.allFinite() && weights_.minCoeff() >= 0,
                 "weights must be finite and not negative");
  }
  std::mt19937_64 rng(0);  // a generator of its own, so that this check does not change the search
  random_task_(rng, x_rand_);
  require_size("random_task", x_rand_.size());
  return true;
}

void TaskSpaceRRT::clear() {
  ob::Planner::clear();
  tree_.reset();
  for (State* start : starts_) si_->freeState(start);
  starts_.clear();
  num_grown_ = num_cycles_ = num_restarts_ = num_steps_ = 0;
  reached_target_ = reached_node_ = -1;
  has_tried_starts_ = false;
  next_target_ = 0;
}

std::size_t TaskSpaceRRT::num_nodes() const {
  return tree_ ? static_cast<std::size_t>(tree_->size()) : 0;
}

TaskSpaceRRT::Node TaskSpaceRRT::node(std::size_t index) const {
  if (index >= num_nodes()) {
    throw std::out_of_range("TaskSpaceRRT: node " + std::to_string(index) + " of " +
                            std::to_string(num_nodes()));
  }
  const int i = static_cast<int>(index);
  return {tree_->state(i), tree_->x(i), tree_->parent(i)};
}

void TaskSpaceRRT::getPlannerData(ob::PlannerData& data) const {
  ob::Planner::getPlannerData(data);
  for (int i = 0; i < static_cast<int>(num_nodes()); ++i) {
    const ob::PlannerDataVertex vertex(tree_->state(i)), parent(tree_->state(tree_->parent(i)));
    tree_->parent(i) == i ? data.addStartVertex(vertex) : data.addEdge(parent, vertex);
  }
  if (reached_node_ >= 0) data.markGoalState(tree_->state(reached_node_));
}

}  // namespace graspless::planning
