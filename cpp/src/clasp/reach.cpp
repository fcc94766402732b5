// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/reach.hpp"

#include <algorithm>

#include "clasp/kinematics.hpp"

namespace graspless::clasp {
namespace {

/// Links from the one that the arm's first joint moves to the hand's frame.
std::vector<int> arm_links(const robot::Robot& robot, const Hand& hand, const Eigen::VectorXd& q) {
  const int first = robot.group(hand.arm).front();
  Eigen::VectorXd moved = q;
  // Half the way to the farther limit: not to where it stands, nor round a whole turn to there.
  const double down = q[first] - robot.lower()[first], up = robot.upper()[first] - q[first];
  moved[first] += up > down ? up / 2 : -down / 2;
  robot::Poses before, after;
  robot.forward(q, before);
  robot.forward(moved, after);
  std::vector<int> links;
  for (int link = robot.frame(hand.frame); link >= 0; link = robot.parent(link)) {
    const auto i = static_cast<std::size_t>(link);
    if (before[i].isApprox(after[i], 1e-12)) break;
    links.push_back(link);
  }
  std::reverse(links.begin(), links.end());
  return links;
}

/// The lengths between consecutive origins, longest over the ends of every sliding joint.
double length(const robot::Robot& robot, const Hand& hand, const std::vector<int>& links,
              Eigen::VectorXd q) {
  Eigen::VectorXd longest = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(links.size()));
  robot::Poses X_WL;
  const auto look = [&] {
    robot.forward(q, X_WL);
    for (std::size_t i = 1; i < links.size(); ++i) {
      const Eigen::Vector3d step = X_WL[static_cast<std::size_t>(links[i])].translation() -
                                   X_WL[static_cast<std::size_t>(links[i - 1])].translation();
      double& most = longest[static_cast<Eigen::Index>(i)];
      most = std::max(most, step.norm());
    }
  };
  for (const int joint : robot.group(hand.arm)) {
    for (const double end : {robot.lower()[joint], robot.upper()[joint]}) {
      q[joint] = end;
      look();
    }
  }
  return longest.sum();
}

/// How far the arm's first joint carries the origin of the link that it moves.
double travel(const robot::Robot& robot, const Hand& hand, int base, Eigen::VectorXd q) {
  const int first = robot.group(hand.arm).front();
  const Eigen::Vector3d from = robot.pose(base, q).translation();
  double most = 0;
  for (const double end : {robot.lower()[first], robot.upper()[first]}) {
    q[first] = end;
    most = std::max(most, (robot.pose(base, q).translation() - from).norm());
  }
  return most;
}

/// The farthest corner of the hand's curves from the hand's frame, open or closed.
double hand_size(const robot::Robot& robot, const Hand& hand) {
  HandKinematics kinematics(robot, hand);
  double farthest = 0;
  for (const std::string& state : {hand.open, hand.closed}) {
    kinematics.update(robot.state(state));
    const Eigen::Vector3d p_WH =
        kinematics.poses()[static_cast<std::size_t>(robot.frame(hand.frame))].translation();
    farthest =
        std::max(farthest, (kinematics.nodes().colwise() - p_WH).colwise().norm().maxCoeff());
  }
  return farthest;
}

}  // namespace

Reach arm_reach(const robot::Robot& robot, const Hand& hand, const Eigen::VectorXd& q) {
  const std::vector<int> links = arm_links(robot, hand, q);
  const int base = links.empty() ? robot.frame(hand.frame) : links.front();
  return {robot.pose(base, q).translation(),
          travel(robot, hand, base, q) + length(robot, hand, links, q) + hand_size(robot, hand)};
}

}  // namespace graspless::clasp
