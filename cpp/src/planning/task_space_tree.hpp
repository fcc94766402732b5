// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <ompl/base/SpaceInformation.h>

#include "graspless/planning/task_space_rrt.hpp"

namespace graspless::planning {

/// T of the algorithm: states and their points in task space, in one array. A root is its own
/// parent. Owns its states.
class TaskSpaceRRT::Tree {
 public:
  Tree(ompl::base::SpaceInformationPtr si, const Eigen::VectorXd& weights, std::size_t num_targets)
      : si_(std::move(si)), weights_(weights), was_extended_(num_targets) {}
  ~Tree() {
    for (State* state : states_) si_->freeState(state);
  }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  int cycles = 0;  ///< of Algorithm 1, since this tree was started

  int add_root(const State* q, const Eigen::VectorXd& x) { return add(q, x, size()); }
  int add(const State* q, const Eigen::VectorXd& x, int parent) {
    if (x_.cols() == size()) x_.conservativeResize(x.size(), std::max(64, 2 * size()));
    x_.col(size()) = x;
    states_.push_back(si_->cloneState(q));
    parents_.push_back(parent);
    for (auto& nodes : was_extended_) nodes.push_back(false);
    return size() - 1;
  }

  /// TS-NEAREST-NEIGHBOR by a linear scan, which breaks ties the same way in every run.
  int nearest(const Eigen::VectorXd& x) const {
    return nearest_of(x, [](int) { return true; });
  }
  /// Nearest node that was not yet extended towards this target; -1 if all were.
  int nearest_unextended(const Eigen::VectorXd& x, std::size_t target) const {
    const std::vector<bool>& extended = was_extended_[target];
    return nearest_of(x, [&](int node) { return !extended[node]; });
  }
  void mark_extended(int node, std::size_t target) { was_extended_[target][node] = true; }
  void mark_extended(int node) {
    for (std::size_t t = 0; t < was_extended_.size(); ++t) mark_extended(node, t);
  }
  double distance(int node, const Eigen::VectorXd& x) const {
    return (x_.col(node) - x).cwiseProduct(weights_).norm();
  }

  int size() const { return static_cast<int>(states_.size()); }
  const State* state(int node) const { return states_[node]; }
  int parent(int node) const { return parents_[node]; }
  Eigen::VectorXd x(int node) const { return x_.col(node); }

 private:
  template <typename Choice>
  int nearest_of(const Eigen::VectorXd& x, const Choice& is_eligible) const {
    int best = -1;
    double least = 0;
    for (int i = 0; i < size(); ++i) {
      if (!is_eligible(i)) continue;
      const double d = (x_.col(i) - x).cwiseProduct(weights_).squaredNorm();
      if (best >= 0 && !(d < least)) continue;
      least = d;
      best = i;
    }
    return best;
  }

  ompl::base::SpaceInformationPtr si_;
  Eigen::VectorXd weights_;
  Eigen::MatrixXd x_;  // one column per node, with columns to spare
  std::vector<State*> states_;
  std::vector<int> parents_;
  std::vector<std::vector<bool>> was_extended_;  // by target, then by node
};

}  // namespace graspless::planning
