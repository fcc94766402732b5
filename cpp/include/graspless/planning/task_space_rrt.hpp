// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <ompl/base/Planner.h>

#include "graspless/export.hpp"

namespace graspless::planning {

/// A tree in task space that a controller grows: Algorithms 1 to 3 of Stork, Pokorny and Kragic
/// 2013.
///
/// Runs on any state space, given a projection to task space and a controller that takes one step
/// towards a task-space target. The space information's motion validator checks motions. The search
/// ends when TS-CONNECT-GOAL reaches a target within the tolerance; without a tolerance, when the
/// problem's goal is satisfied. A tree that has not reached a target after restart_cycles() cycles
/// is discarded, and a new one is grown. Calling solve() again continues with the next target and
/// the current tree, and does not return the same node again.
///
/// The controller must be deterministic in its arguments: a node that was extended towards a target
/// once is not extended towards it again.
///
/// Repeatable for one seed: OMPL's random numbers are not used.
class GRASPLESS_API TaskSpaceRRT : public ompl::base::Planner {
 public:
  using State = ompl::base::State;
  /// TS-PROJECTION: writes the task-space point x of a state; its size must not change.
  using Projection = std::function<void(const State* q, Eigen::VectorXd& x)>;
  /// TS-CONTROL: writes the state one step from q towards x_target. False if the controller stalls,
  /// which ends a connection like a collision. `is_exploring` is true in TS-EXTEND.
  using Controller =
      std::function<bool(const State* q, const Eigen::VectorXd& x, const Eigen::VectorXd& x_target,
                         bool is_exploring, State* q_new)>;
  /// RANDOM-TS-SAMPLE.
  using RandomTask = std::function<void(std::mt19937_64& rng, Eigen::VectorXd& x)>;
  /// TS-TOLERANCE: true if x is near enough to a target.
  using Tolerance = std::function<bool(const Eigen::VectorXd& x_target, const Eigen::VectorXd& x)>;

  explicit TaskSpaceRRT(const ompl::base::SpaceInformationPtr& si);
  ~TaskSpaceRRT() override;

  void set_projection(Projection projection) { project_ = std::move(projection); }
  void set_controller(Controller controller) { control_ = std::move(controller); }
  void set_random_task(RandomTask draw) { random_task_ = std::move(draw); }
  void set_tolerance(Tolerance tolerance) { tolerance_ = std::move(tolerance); }
  /// Sets the task-space goals, tried in this order in every cycle. Discards the current tree.
  void set_targets(std::vector<Eigen::VectorXd> x);
  /// Sets the weights of the coordinates of x in the nearest-neighbour distance; all 1 by default.
  void set_weights(const Eigen::VectorXd& weights) { weights_ = weights; }
  void set_seed(std::uint64_t seed) { rng_.seed(seed); }

  void set_random_probability(double probability);  ///< P, in [0, 1); default 0.1
  double random_probability() const { return random_probability_; }
  void set_pre_expansions(int expansions);  ///< n: random extensions of a new tree; default 50
  /// Sets n for the first tree, the second, ...; the last number holds for all further trees.
  void set_pre_expansion_schedule(std::vector<int> expansions);
  int pre_expansions() const { return pre_expansions_.front(); }
  void set_max_iterations(std::int64_t cycles);  ///< K of one solve(), over all its trees
  void set_restart_cycles(int cycles);  ///< cycles before a tree is discarded; 0: never; default 20
  int restart_cycles() const { return restart_cycles_; }
  void set_max_connect_steps(int steps);  ///< control steps of one TS-CONNECT-GOAL; default 150

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
  void clear() override;
  void getPlannerData(ompl::base::PlannerData& data) const override;

  /// A node of the current tree.
  struct Node {
    const State* state;
    Eigen::VectorXd x;
    int parent;  ///< index; a root has its own
  };
  std::size_t num_nodes() const;                               ///< of the last tree
  Node node(std::size_t index) const;                          ///< of the last tree
  std::int64_t num_nodes_grown() const { return num_grown_; }  ///< of all trees
  std::int64_t num_cycles() const { return num_cycles_; }      ///< of all trees: k of Algorithm 1
  std::int64_t num_restarts() const { return num_restarts_; }  ///< trees discarded
  std::int64_t num_steps() const { return num_steps_; }        ///< control steps
  int reached_target() const { return reached_target_; }       ///< index; -1 until one is reached
  int reached_node() const { return reached_node_; }  ///< of the last tree; -1 until one is reached

 private:
  class Tree;
  using Termination = ompl::base::PlannerTerminationCondition;

  void check_setup() const;
  bool read_starts();
  void start_tree(const Termination& ptc);
  bool is_exhausted() const;
  bool starts_at_goal();
  bool ts_extend(const Eigen::VectorXd& x);
  bool ts_connect_goal(std::size_t target, const Termination& ptc);
  int step(int near, const Eigen::VectorXd& x, bool is_exploring);
  bool is_reached(int node, std::size_t target);
  void accept(int node, std::size_t target);

  Projection project_;
  Controller control_;
  RandomTask random_task_;
  Tolerance tolerance_;
  std::vector<Eigen::VectorXd> targets_;
  Eigen::VectorXd weights_;
  std::mt19937_64 rng_{1};
  double random_probability_ = 0.1;
  std::vector<int> pre_expansions_{50};
  int restart_cycles_ = 20;
  int max_connect_steps_ = 150;
  std::int64_t max_iterations_;
  std::vector<State*> starts_;
  std::unique_ptr<Tree> tree_;
  State* q_new_;
  Eigen::VectorXd x_new_, x_rand_;
  std::size_t next_target_ = 0;  // where to continue the cycle that the last solution interrupted
  std::int64_t num_grown_ = 0, num_cycles_ = 0, num_restarts_ = 0, num_steps_ = 0;
  int reached_target_ = -1, reached_node_ = -1;
  bool has_tried_starts_ = false;  // true once the starts were checked against the targets
};

}  // namespace graspless::planning
