// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/clasp/hand.hpp"

namespace graspless::clasp {

/// A ball that the hand's curves never leave, whatever the arm does.
struct Reach {
  Eigen::Vector3d base_W;  ///< where the arm's first joint stands [m]
  double radius;           ///< the lengths of the arm's links and the hand's size, summed [m]

  /// How far a point lies outside; not positive inside [m].
  double excess(const Eigen::Vector3d& p_W) const { return (p_W - base_W).norm() - radius; }
};

/// Of the arm that stands at q.
Reach arm_reach(const robot::Robot& robot, const Hand& hand, const Eigen::VectorXd& q);

}  // namespace graspless::clasp
