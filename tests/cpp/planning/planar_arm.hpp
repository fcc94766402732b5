// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A planar arm that TaskSpaceRRT leads with its tip.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>

#include "graspless/planning/task_space_rrt.hpp"
#include "graspless/planning/vector_states.hpp"

namespace graspless::planning {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// A planar arm of n links of equal length, 1 m in all; its task is where the tip is.
class PlanarArm {
 public:
  explicit PlanarArm(int joints) : n_(joints) {}

  /// Joints of the chain, the base first, the tip last.
  Eigen::Matrix2Xd points(const Eigen::VectorXd& q) const {
    Eigen::Matrix2Xd p = Eigen::Matrix2Xd::Zero(2, n_ + 1);
    double angle = 0;
    for (int i = 0; i < n_; ++i) {
      angle += q[i];
      p.col(i + 1) = p.col(i) + Eigen::Vector2d(std::cos(angle), std::sin(angle)) / n_;
    }
    return p;
  }
  Eigen::Vector2d tip(const Eigen::VectorXd& q) const { return points(q).col(n_); }

  /// A step of a damped pseudo-inverse, no joint by more than `max_step`.
  bool control(const Eigen::VectorXd& q, const Eigen::Vector2d& target, double max_step,
               Eigen::VectorXd& q_new) const {
    const Eigen::Matrix2Xd p = points(q);
    Eigen::Matrix2Xd J(2, n_);
    for (int i = 0; i < n_; ++i) {
      const Eigen::Vector2d r = p.col(n_) - p.col(i);
      J.col(i) << -r.y(), r.x();
    }
    const Eigen::Matrix2d A = J * J.transpose() + 1e-4 * Eigen::Matrix2d::Identity();
    Eigen::VectorXd dq = 0.5 * J.transpose() * A.inverse() * (target - p.col(n_));
    const double most = dq.cwiseAbs().maxCoeff();
    if (most < 2e-4) return false;
    if (most > max_step) dq *= max_step / most;
    q_new = q + dq;
    return true;
  }

 private:
  int n_;
};

/// Discs that no link may touch.
struct Disc {
  Eigen::Vector2d centre;
  double radius;
};

inline bool is_arm_free(const Eigen::Matrix2Xd& p, const std::vector<Disc>& discs) {
  for (const Disc& disc : discs) {
    for (Eigen::Index i = 0; i + 1 < p.cols(); ++i) {
      const Eigen::Vector2d a = p.col(i), d = p.col(i + 1) - a;
      const double t = std::clamp((disc.centre - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      if ((a + t * d - disc.centre).norm() < disc.radius) return false;
    }
  }
  return true;
}

/// A planar arm in OMPL's SimpleSetup.
class ArmQuery {
 public:
  ArmQuery(int joints, std::vector<Disc> discs)
      : n_(joints),
        arm_(joints),
        setup_(
            make_box(Eigen::VectorXd::Constant(joints, -3), Eigen::VectorXd::Constant(joints, 3))) {
    si_ = setup_.getSpaceInformation();
    setup_.setStateValidityChecker([this, discs](const ob::State* s) {
      ++num_checks;
      return is_arm_free(arm_.points(vector(s, n_)), discs);
    });
    si_->setStateValidityCheckingResolution(0.002);
    planner = std::make_shared<TaskSpaceRRT>(si_);
    planner->set_projection(
        [this](const ob::State* s, Eigen::VectorXd& x) { x = arm_.tip(vector(s, n_)); });
    planner->set_controller([this](const ob::State* s, const Eigen::VectorXd& x,
                                   const Eigen::VectorXd& x_target, bool is_exploring,
                                   ob::State* s_new) {
      EXPECT_EQ(x, arm_.tip(vector(s, n_)));
      if (on_control) on_control(s, x_target, is_exploring);
      Eigen::VectorXd q_new;
      if (!arm_.control(vector(s, n_), x_target, is_exploring ? 0.5 : 0.1, q_new)) return false;
      vector(s_new, n_) = q_new;
      return true;
    });
    planner->set_random_task([](std::mt19937_64& rng, Eigen::VectorXd& x) {
      std::uniform_real_distribution<double> place(-1, 1);
      x.resize(2);
      for (double& coordinate : x) coordinate = place(rng);
    });
    planner->set_tolerance([](const Eigen::VectorXd& x_target, const Eigen::VectorXd& x) {
      return (x_target - x).norm() < 0.02;
    });
    planner->set_targets({Eigen::Vector2d(-0.5, 0.1)});
    planner->set_pre_expansions(20);
    planner->set_seed(1);
    setup_.setPlanner(planner);
    start(Eigen::VectorXd::Constant(n_, 0.1));
  }

  void start(const Eigen::VectorXd& q) {
    ob::ScopedState<ob::RealVectorStateSpace> state(si_->getStateSpace());
    vector(state.get(), n_) = q;
    setup_.setStartState(state);
  }
  /// Searches until the planner has tested its termination condition a million times. Unlike a time
  /// limit, this does not depend on sanitizers or load.
  ob::PlannerStatus solve() {
    ob::IterationTerminationCondition is_over(1'000'000);
    return setup_.solve(is_over);
  }
  Path path() {
    const ob::PathPtr found = setup_.getProblemDefinition()->getSolutionPath();
    if (!found) throw std::logic_error("there is no path");
    return to_path(found, n_);
  }
  Eigen::Vector2d tip() { return arm_.tip(path().back()); }
  const ob::SpaceInformationPtr& si() const { return si_; }
  og::SimpleSetup& setup() { return setup_; }

  std::shared_ptr<TaskSpaceRRT> planner;
  std::function<void(const ob::State*, const Eigen::VectorXd&, bool)> on_control;
  int num_checks = 0;

 private:
  int n_;
  PlanarArm arm_;
  og::SimpleSetup setup_;
  ob::SpaceInformationPtr si_;
};

}  // namespace graspless::planning
