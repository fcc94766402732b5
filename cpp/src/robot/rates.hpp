// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "graspless/robot/robot.hpp"

namespace graspless::robot {

/// Rates of a point of a link along a direction, per unit of each joint [m/rad or 1], 1 x dof. By
/// virtual work, a force of 1 N there asks the joints for these efforts [Nm or N].
inline Eigen::RowVectorXd rates(const Robot& robot, int link, const Poses& X_WL,
                                const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> J;
  robot.jacobian(link, X_WL, J);
  const Eigen::Vector3d arm = p_W - X_WL[link].translation();
  return direction_W.transpose() * J.topRows<3>() +
         arm.cross(direction_W).transpose() * J.bottomRows<3>();  // direction . (w x arm)
}

}  // namespace graspless::robot
