// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Corners of finger curves in the palm.
#include "clasp/hand/palm.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;

constexpr double kSame = 1e-3;  // corners that are nearer than this are one [m]

Vector3d position_in_palm(const Hand& hand, const robot::Robot& robot, const CurveNode& node,
                          const Eigen::VectorXd& q) {
  return robot.pose(robot.frame(hand.frame), q).inverse() * node_position(robot, node, q);
}

void add_palm_corner(const Hand& hand, const robot::Robot& robot, Finger& finger) {
  if (finger.nodes.empty() || !moves_in_palm(hand, robot, finger.nodes.front())) return;
  const CurveNode& first = finger.nodes.front();
  const Vector3d open = position_in_palm(hand, robot, first, robot.state(hand.open));
  const Vector3d closed = position_in_palm(hand, robot, first, robot.state(hand.closed));
  if ((open - closed).norm() < kSame) finger.nodes.erase(finger.nodes.begin());
  finger.nodes.insert(finger.nodes.begin(), {hand.frame, (open + closed) / 2});
}

}  // namespace

Vector3d node_position(const robot::Robot& robot, const CurveNode& node, const Eigen::VectorXd& q) {
  return robot.pose(robot.frame(node.link), q) * node.p_L;
}

bool moves_in_palm(const Hand& hand, const robot::Robot& robot, const CurveNode& node) {
  return a_joint_changes(hand, robot,
                         [&](const auto& q) { return position_in_palm(hand, robot, node, q); });
}

Hand with_palm_corners(const Hand& hand, const robot::Robot& robot) {
  require_names(hand, robot);
  Hand made = hand;
  for (Finger& finger : made.fingers) add_palm_corner(hand, robot, finger);
  add_palm_corner(hand, robot, made.thumb);
  return made;
}

}  // namespace graspless::clasp
