// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Our robots with a hand that clasps.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "graspless/clasp/hand.hpp"
#include "graspless/robot/robot.hpp"

#include "paths.hpp"

namespace graspless::clasp {

struct RobotWithHand {
  robot::Robot robot;
  Hand hand;
};

/// kr5_sdh, kr5_dlr, kr5_icub, kr5_armar or wam_t42.
inline RobotWithHand robot_with_hand(const std::string& name) {
  const std::string stem = urdf_file(name);
  return {robot::Robot::from_urdf_file(stem + ".urdf"), hand_from_yaml_file(stem + ".clasp.yaml")};
}

inline const std::vector<std::string>& robots_with_hands() {
  static const std::vector<std::string> names{"kr5_sdh", "kr5_dlr", "kr5_icub", "kr5_armar",
                                              "wam_t42"};
  return names;
}

/// The arm where it stands at home, the hand's joints as in the state of that name.
inline Eigen::VectorXd at_home(const RobotWithHand& r, const std::string& state) {
  Eigen::VectorXd q = r.robot.state("home");
  for (const int joint : r.robot.group(r.hand.hand)) q[joint] = r.robot.state(state)[joint];
  return q;
}

/// Where a corner of a curve is.
inline Eigen::Vector3d place(const RobotWithHand& r, const CurveNode& node,
                             const Eigen::VectorXd& q) {
  return r.robot.pose(r.robot.frame(node.link), q) * node.p_L;
}

}  // namespace graspless::clasp
