// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/clasp/hand.hpp"

namespace graspless::clasp {

/// A ball that contains the finger curves in every configuration of the arm.
struct Reach {
  Eigen::Vector3d base_W;  ///< centre: the arm's first link, at mid-range if it slides [m]
  /// Sum of the lengths of the arm's links, of its sliding joints' travel and of the hand's size
  /// [m].
  double radius;

  /// Distance of a point from the ball [m]; not positive inside.
  double excess(const Eigen::Vector3d& p_W) const { return (p_W - base_W).norm() - radius; }
};

/// Reach of the arm of a valid hand. Joints outside the arm keep their values from q.
Reach arm_reach(const robot::Robot& robot, const Hand& hand, Eigen::VectorXd q);

}  // namespace graspless::clasp
