// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "graspless/robot/ik.hpp"

namespace graspless::robot {

/// Twist from X_WA to X_WB, linear part first: displacement of the origin [m], rotation vector
/// [rad], in W.
Eigen::Matrix<double, 6, 1> pose_error(const Eigen::Isometry3d& X_WA,
                                       const Eigen::Isometry3d& X_WB);

/// Newton's method on the pose error, damped by the error itself (Sugihara, IEEE T-RO 2011): it
/// converges quadratically and takes no large steps near a singularity. A joint that would leave
/// its limits is held there, and the other joints take over.
class DampedLeastSquares {
 public:
  DampedLeastSquares(const Robot& robot, int frame, const std::vector<int>& group)
      : robot_(robot), frame_(frame), group_(group) {}

  /// Moves the group's joints in q until the frame is at X_WF within the tolerance of the options.
  /// Where it may lean, the position counts more than the angle near the pose. With
  /// `pull`, the null space of a redundant arm moves towards the middle of its limits. Returns
  /// false if it does not converge; q is then undefined.
  bool solve(const Eigen::Isometry3d& X_WF, const Ik::Options& options, bool pull,
             Eigen::VectorXd& q);

 private:
  using Vector6d = Eigen::Matrix<double, 6, 1>;
  using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

  void step(Vector6d error, double weight, bool pull, Eigen::VectorXd& q);
  void solve_free_joints(const Vector6d& error, const Eigen::VectorXd& wish);
  bool hold_at_limits(const Eigen::VectorXd& q);

  const Robot& robot_;
  const int frame_;
  const std::vector<int>& group_;
  Poses X_WL_;  // scratch memory, allocated once
  Jacobian J_all_, J_;
  Eigen::VectorXd dq_, wish_;
};

}  // namespace graspless::robot
