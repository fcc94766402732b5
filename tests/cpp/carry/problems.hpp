// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "graspless/carry/carry.hpp"

#include "paths.hpp"

/// A box in the hands of the WAM and of the KR5, as the tests of carrying need them.
namespace graspless::carry {

inline const robot::Robot& wam() {
  static const auto robot = robot::Robot::from_urdf_file(urdf_file("wam_t42.urdf"));
  return robot;
}

inline const robot::Robot& kr5() {
  static const auto robot = robot::Robot::from_urdf_file(urdf_file("kr5_t42.urdf"));
  return robot;
}

inline Obstacle box(const std::string& name, const Eigen::Vector3d& size,
                    const Eigen::Isometry3d& X_WB) {
  return {name, {{geometry::Box{size}, Eigen::Isometry3d::Identity()}}, X_WB};
}

inline Eigen::Isometry3d moved(const Eigen::Isometry3d& X, const Eigen::Vector3d& by_W) {
  return Eigen::Translation3d(by_W) * X;
}

/// A box 10 cm long that the open hand holds at its middle, to be taken by `by_W`.
inline Problem held_box(const robot::Robot& robot, const Eigen::VectorXd& q,
                        const Eigen::Vector3d& by_W) {
  const Eigen::Isometry3d X_WO = robot.pose(robot.frame("grasp"), q);
  return {robot, "arm", "grasp", box("box", {0.10, 0.03, 0.03}, X_WO), moved(X_WO, by_W),
          {},    {},    q};
}

inline Problem held_box(const robot::Robot& robot, const Eigen::Vector3d& by_W) {
  return held_box(robot, robot.state("home"), by_W);
}

}  // namespace graspless::carry
