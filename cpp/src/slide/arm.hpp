// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/slide/slide.hpp"

namespace graspless::slide {

/// Distance that plans keep between links that the arm moves relative to each other [m]. A
/// controller holds the joints to some milliradians, and nothing must touch then. What stands
/// around the robot can be padded in the problem; the robot's own links cannot.
inline constexpr double kLinkClearance = 2e-3;
/// The same for motions that a follower shifts off a plan, which may use up the rest [m].
inline constexpr double kShiftedClearance = 5e-4;

/// The joints that the search moves: those of the hand's arm. All others stay at q_home, with the
/// hand open.
class GRASPLESS_API Arm {
 public:
  explicit Arm(const Problem& problem)
      : Arm(problem, problem.robot.state(problem.hand.open, problem.q_home)) {}
  /// With the hand as in `q_open` instead of open.
  Arm(const Problem& problem, Eigen::VectorXd q_open)
      : joints_(problem.robot.group(problem.hand.arm)), q_open_(std::move(q_open)) {
    lower_ = part(problem.robot.lower());
    upper_ = part(problem.robot.upper());
    weights_ = part(problem.robot.step_weights());
    const Eigen::VectorXd home = part(problem.q_home);
    write(home, q_open_);
    q_closed_ = problem.robot.state(problem.hand.closed, q_open_);
    write(home, q_closed_);
  }

  int dof() const { return static_cast<int>(joints_.size()); }
  const std::vector<int>& joints() const { return joints_; }
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }
  const Eigen::VectorXd& open() const { return q_open_; }      ///< q_home with the hand open
  const Eigen::VectorXd& closed() const { return q_closed_; }  ///< q_home with the hand closed

  /// Robot::step() of a change of the arm's joints [rad].
  double span(const Eigen::VectorXd& change) const {
    return change.cwiseProduct(weights_).lpNorm<Eigen::Infinity>();
  }
  /// Writes the arm's joints into a configuration q of all joints.
  void write(const Eigen::Ref<const Eigen::VectorXd>& arm, Eigen::VectorXd& q) const {
    for (int i = 0; i < dof(); ++i) q[joints_[i]] = arm[i];
  }
  /// Returns the configuration of all joints with the arm at `arm` and the hand open.
  Eigen::VectorXd full(const Eigen::Ref<const Eigen::VectorXd>& arm) const {
    Eigen::VectorXd q = q_open_;
    write(arm, q);
    return q;
  }
  /// Returns the arm's joints of a configuration q.
  Eigen::VectorXd part(const Eigen::VectorXd& q) const {
    Eigen::VectorXd arm(dof());
    for (int i = 0; i < dof(); ++i) arm[i] = q[joints_[i]];
    return arm;
  }

 private:
  std::vector<int> joints_;
  Eigen::VectorXd lower_, upper_, weights_, q_open_, q_closed_;
};

}  // namespace graspless::slide
