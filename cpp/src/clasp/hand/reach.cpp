// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/hand/reach.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "clasp/hand/kinematics.hpp"
#include "robot/moved_links.hpp"

namespace graspless::clasp {
namespace {

/// Sum of the distances between consecutive link origins, starting at the base. Each is the largest
/// over the limits of all joints.
double arm_length(const robot::Robot& robot, const Hand& hand, const std::vector<int>& links,
                  const Eigen::Vector3d& base_W, Eigen::VectorXd q) {
  Eigen::VectorXd longest = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(links.size()));
  robot::Poses X_WL;
  const auto update = [&] {
    robot.forward(q, X_WL);
    Eigen::Vector3d last_W = base_W;
    for (std::size_t i = 0; i < links.size(); ++i) {
      const Eigen::Vector3d p_W = X_WL[links[i]].translation();
      double& most = longest[i];
      most = std::max(most, (p_W - last_W).norm());
      last_W = p_W;
    }
  };
  for (const int joint : robot.group(hand.arm)) {
    for (const double end : {robot.lower()[joint], robot.upper()[joint]}) {
      q[joint] = end;
      update();
    }
  }
  return longest.sum();
}

/// Largest distance of a node from the hand's frame, in the states of the hand [m].
double hand_size(const robot::Robot& robot, const Hand& hand) {
  HandKinematics kinematics(robot, hand);
  double farthest = 0;
  std::vector<std::string> states = hand.pre_shapes;
  states.insert(states.end(), {hand.open, hand.closed});
  for (const std::string& state : states) {
    kinematics.update(robot.state(state));
    const Eigen::Vector3d p_WH = kinematics.poses()[robot.frame(hand.frame)].translation();
    farthest =
        std::max(farthest, (kinematics.nodes().colwise() - p_WH).colwise().norm().maxCoeff());
  }
  return farthest;
}

}  // namespace

Reach arm_reach(const robot::Robot& robot, const Hand& hand, Eigen::VectorXd q) {
  for (const int joint : robot.group(hand.arm)) {
    q[joint] = (robot.lower()[joint] + robot.upper()[joint]) / 2;
  }
  const std::vector<int> links =
      robot::moved_links(robot, robot.group(hand.arm), robot.frame(hand.frame), q);
  const Eigen::Vector3d base_W = robot.pose(links.front(), q).translation();
  return {base_W, arm_length(robot, hand, links, base_W, q) + hand_size(robot, hand)};
}

}  // namespace graspless::clasp
