// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/clasp/hand.hpp"

namespace graspless::clasp {

/// Position of a node in W [m].
Eigen::Vector3d node_position(const robot::Robot& robot, const CurveNode& node,
                              const Eigen::VectorXd& q);

/// True if moving a single joint of the hand from the open state changes `measure(q)`.
template <typename Measure>
bool a_joint_changes(const Hand& hand, const robot::Robot& robot, Measure measure) {
  const Eigen::VectorXd open = robot.state(hand.open);
  for (const int joint : robot.group(hand.hand)) {
    Eigen::VectorXd moved = open;
    moved[joint] += 0.1;
    if ((measure(moved) - measure(open)).norm() > 1e-6) return true;
  }
  return false;
}

/// True if joints of the hand move a point of a link against the palm.
bool moves_in_palm(const Hand& hand, const robot::Robot& robot, const CurveNode& node);

/// Throws std::invalid_argument unless the names, directions and nodes of a hand are valid; its
/// curves are not tested.
void require_names(const Hand& hand, const robot::Robot& robot);

}  // namespace graspless::clasp
