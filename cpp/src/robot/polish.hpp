// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <Eigen/Geometry>

#include "robot/subproblems.hpp"

namespace graspless::robot {

/// Newton's method on the kinematics of six or seven revolute joints, six of which move.
struct Polish {
  static constexpr double kTolerance = 1e-10;  // pose error of an answer [m, rad]

  /// Improves the moving joints of `q` until the last link is at `X_PE`; false if it does not
  /// converge.
  bool operator()(const Eigen::Isometry3d& X_PE, double* q) const;

  int size = 6;                 // number of joints
  int held = -1;                // the joint that does not move; -1: none
  std::array<Screw, 7> screws;  // in P, at q = 0
  Eigen::Isometry3d X_PE_zero = Eigen::Isometry3d::Identity();  // at q = 0

 private:
  using Vector6d = Eigen::Matrix<double, 6, 1>;
  using Matrix6d = Eigen::Matrix<double, 6, 6>;

  Vector6d error_and_jacobian(const Eigen::Isometry3d& X_PE, const double* q, Matrix6d& J) const;
};

}  // namespace graspless::robot
