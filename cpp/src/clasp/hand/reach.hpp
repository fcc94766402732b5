// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/clasp/hand.hpp"

namespace graspless::clasp {

/// A ball that the hand's curves never leave, whatever the arm does.
struct Reach {
  Eigen::Vector3d base_W;  ///< of the arm's first link; if that slides, half way along [m]
  /// The lengths of the arm's links, the way that the first may slide from the base and the hand's
  /// size, summed [m].
  double radius;

  /// How far a point lies outside; not positive inside [m].
  double excess(const Eigen::Vector3d& p_W) const { return (p_W - base_W).norm() - radius; }
};

/// Of a valid hand's arm, wherever it stands; joints outside the arm stay as in q.
Reach arm_reach(const robot::Robot& robot, const Hand& hand, Eigen::VectorXd q);

}  // namespace graspless::clasp
