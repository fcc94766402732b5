// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/loop_search.hpp"

#include <array>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>

#include "graspless/planning/vector_states.hpp"
#include "graspless/watch.hpp"

#include "clasp/parameters.hpp"

namespace graspless::clasp {

namespace ob = ompl::base;
using planning::vector;

namespace {

// Parameters of Algorithm 1 and 2 that suit every hand and object so far.
constexpr double kRandomProbability = 0.1;                 // P
constexpr std::array kPreExpansions = {20, 50, 100, 200};  // n of the first tree, the second, ...
constexpr int kRestartCycles = 5;                          // before a tree is given up
constexpr int kMaxConnectSteps = 150;                      // of one connection
constexpr double kMaxStep = 0.12;                          // LIMIT-STEP-SIZE, of any joint [rad]
constexpr double kExploringStep = 0.35;                    // of TS-EXTEND, of any joint [rad]
// Of the linking in the nearest-neighbour distance: linked once weighs as much as 0.3 m [m].
constexpr double kLinkingWeight = 0.3;

constexpr int kStall = 12;       // control steps without progress that end tighten()
constexpr double kMargin = 0.3;  // of the box of random samples around hand and object [m]

/// COLLISION-FREE of Algorithms 2 and 3.
class FreeMotion : public ob::MotionValidator {
 public:
  FreeMotion(const ob::SpaceInformationPtr& si, Query& query)
      : MotionValidator(si), query_(query), dof_(query.problem.robot.dof()) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return query_.accept_motion(vector(a, dof_), vector(b, dof_));
  }
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>&) const override {
    return checkMotion(a, b);
  }

 private:
  Query& query_;
  Eigen::Index dof_;
};

}  // namespace

LoopSearch::LoopSearch(Query& query, const LoopTask& task, const Eigen::VectorXd& q_start)
    : ClaspSearch(query, task),
      controller_(task_space_, query.problem.robot, query.problem.hand, task.options),
      dof_(query.problem.robot.dof()) {
  workspace_W_.extend(project(q_start).head<3>());
  const Eigen::Matrix3Xd object_W = query.problem.X_WO * query.problem.object.points();
  workspace_W_.extend(object_W.rowwise().minCoeff()).extend(object_W.rowwise().maxCoeff());
  workspace_W_.extend(workspace_W_.min() - Eigen::Vector3d::Constant(kMargin));
  workspace_W_.extend(workspace_W_.max() + Eigen::Vector3d::Constant(kMargin));
  make_space(q_start);
  make_planner();
}

void LoopSearch::make_space(const Eigen::VectorXd& q_start) {
  const robot::Robot& robot = query_.problem.robot;
  const auto box = planning::make_box(robot.lower(), robot.upper());
  si_ = std::make_shared<ob::SpaceInformation>(box);
  si_->setStateValidityChecker(
      [this](const ob::State* q) { return query_.free.is_free(vector(q, dof_)); });
  si_->setMotionValidator(std::make_shared<FreeMotion>(si_, query_));
  si_->setup();
  problem_ = std::make_shared<ob::ProblemDefinition>(si_);
  ob::ScopedState<ob::RealVectorStateSpace> start(box);
  vector(start.get(), dof_) = q_start;
  problem_->addStartState(start);
}

void LoopSearch::make_planner() {
  planner_ = std::make_shared<planning::TaskSpaceRRT>(si_);
  planner_->setProblemDefinition(problem_);
  planner_->set_seed(query_.rng());
  planner_->set_random_probability(kRandomProbability);
  planner_->set_pre_expansion_schedule({kPreExpansions.begin(), kPreExpansions.end()});
  planner_->set_restart_cycles(kRestartCycles);
  planner_->set_max_connect_steps(kMaxConnectSteps);
  planner_->set_max_iterations(1);
  Eigen::VectorXd weights(5);
  weights << 1, 1, 1, kLinkingWeight, 0;
  planner_->set_weights(weights);
  std::vector<Eigen::VectorXd> goals;
  for (const geometry::ClaspTarget& target : task_.targets_W) {
    goals.emplace_back(5);
    goals.back() << target.point, 1, 1;  // Algorithm 1: 9
  }
  planner_->set_targets(goals);
  planner_->set_projection(
      [this](const ob::State* q, Eigen::VectorXd& x) { x = project(vector(q, dof_)); });
  planner_->set_controller(
      [this, q_new = Eigen::VectorXd(dof_)](const ob::State* q, const Eigen::VectorXd&,
                                            const Eigen::VectorXd& x_target, bool is_exploring,
                                            ob::State* new_state) mutable {
        const double step = is_exploring ? kExploringStep : kMaxStep;
        const bool is_aligned = !is_stuck() || !is_exploring;
        if (!controller_.step(vector(q, dof_), x_target.head<4>(), step, q_new, is_aligned)) {
          query_.refuse("control: stalled");
          return false;
        }
        vector(new_state, dof_) = q_new;
        return true;
      });
  planner_->set_random_task(
      [this](std::mt19937_64& rng, Eigen::VectorXd& x) { draw_task(rng, x); });
  planner_->set_tolerance(
      [this](const Eigen::VectorXd&, const Eigen::VectorXd& x) { return is_enough(x[4]); });
}

// Turning the hand to the loop may push it into the object in every step from the start: Algorithm
// 2 turns it in all. Once a tree was given up at its root, later ones explore without turning.
bool LoopSearch::is_stuck() {
  if (planner_->num_restarts() != restarts_) was_stuck_ = was_stuck_ || nodes_ == 1;
  restarts_ = planner_->num_restarts();
  nodes_ = planner_->num_nodes();
  return was_stuck_;
}

// RANDOM-TS-SAMPLE of Algorithm 1.
void LoopSearch::draw_task(std::mt19937_64& rng, Eigen::VectorXd& x) const {
  x.resize(5);
  for (Eigen::Index i = 0; i < 3; ++i) {
    x[i] =
        std::uniform_real_distribution<double>(workspace_W_.min()[i], workspace_W_.max()[i])(rng);
  }
  x[3] = std::uniform_real_distribution<double>(0, 1)(rng);
  x[4] = x[3];
}

bool LoopSearch::cycle() {
  problem_->clearSolutionPaths();
  const ob::PlannerTerminationCondition is_out([this] { return query_.clock.is_out(); });
  return planner_->solve(is_out) == ob::PlannerStatus::EXACT_SOLUTION;
}

planning::Path LoopSearch::path() {
  planning::Path path = planning::to_path(problem_->getSolutionPath(), dof_);
  tighten(path);
  return path;
}

void LoopSearch::tighten(planning::Path& path) {
  TaskPoint goal;
  goal << reached_W().point, 1;
  Eigen::VectorXd q_new(dof_);
  double least = 1e9;
  int stalled = 0;
  for (int i = 0; i < kMaxConnectSteps && stalled < kStall; ++i) {
    poll();
    if (!controller_.step(path.back(), goal, kMaxStep, q_new)) return;
    const Eigen::VectorXd x = project(q_new);
    if (!is_enough(x[4]) || !query_.is_motion_free(path.back(), q_new)) return;
    Eigen::Vector4d left = x.head<4>() - goal;
    left[3] *= kLinkingWeight;
    stalled = left.norm() < least - 1e-4 ? 0 : stalled + 1;
    least = std::min(least, left.norm());
    path.push_back(q_new);
  }
}

const geometry::ClaspTarget& LoopSearch::reached_W() const {
  return task_.targets_W[planner_->reached_target()];
}

Effort LoopSearch::effort() const {
  return {planner_->num_cycles(), planner_->num_nodes_grown(), planner_->num_restarts(),
          planner_->num_steps()};
}

Tree LoopSearch::tree() const {
  Tree tree;
  const std::size_t n = planner_->num_nodes();
  tree.p_W.resize(3, static_cast<Eigen::Index>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const auto node = planner_->node(i);
    tree.p_W.col(i) = node.x.head<3>();
    tree.parents.push_back(node.parent);
  }
  tree.path = {planner_->reached_node()};
  while (tree.path.back() != 0) {
    tree.path.push_back(tree.parents[tree.path.back()]);
  }
  std::reverse(tree.path.begin(), tree.path.end());
  return tree;
}

}  // namespace graspless::clasp
