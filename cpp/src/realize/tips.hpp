// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Inverse kinematics of several fingertips at once, by their positions alone.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "graspless/robot/robot.hpp"

namespace graspless::realize {

/// A set of fingers, as bits: finger i by 1 << i.
using FingerMask = unsigned;

/// Target positions of fingertips: column i for finger i, those in `held` only.
struct TipTargets {
  Eigen::Matrix3Xd p_WT;  // [m]
  FingerMask held = 0;
};

/// Damped least squares over all joints that move any fingertip, within limits. Joints that move
/// none stay as they are.
class TipIk {
 public:
  /// `frames`: of each finger's fingertip.
  TipIk(const robot::Robot& robot, std::vector<int> frames);

  const robot::Robot& robot() const { return robot_; }
  const std::vector<int>& joints() const { return joints_; }  // that move a fingertip
  const std::string& fingertip(int finger) const;
  Eigen::Isometry3d pose(int finger, const Eigen::VectorXd& q) const;

  /// Moves q to the targets by steps of least norm, within the joints' limits. True if every
  /// fingertip came to within `tolerance` [m]. If not, q is the best that was found.
  bool solve(const TipTargets& targets, double tolerance, int max_iterations, Eigen::VectorXd& q);

  /// A step from q towards the targets that turns the held fingertips with an object, as far as
  /// their positions leave room. The object turns by `turn_W` [rad] meanwhile. Rotation about the
  /// contacts' normals (columns of n_W) is free. Spheres whose contact points stay should not roll
  /// on the surface.
  Eigen::VectorXd step_along(const TipTargets& targets, const Eigen::Vector3d& turn_W,
                             const Eigen::Matrix3Xd& n_W, const Eigen::VectorXd& q);

  /// The largest distance of a fingertip from its target [m], and which finger's.
  std::pair<double, int> miss(const TipTargets& targets, const Eigen::VectorXd& q);

 private:
  using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;
  double errors(const TipTargets& targets, const Eigen::VectorXd& q);
  void jacobians(const TipTargets& targets);
  Eigen::VectorXd with(const Eigen::VectorXd& q, const Eigen::VectorXd& dq) const;
  Eigen::VectorXd step(const Eigen::VectorXd& q, double damping);

  robot::Robot robot_;
  std::vector<int> frames_, joints_;
  robot::Poses X_WL_;
  Eigen::VectorXd error_;   // stacked, 3 a held finger [m]
  Eigen::MatrixXd J_;       // of the stacked positions by joints_
  Eigen::MatrixXd J_turn_;  // of the stacked rotations
  Jacobian J_frame_;
};

}  // namespace graspless::realize
