// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "graspless/robot/robot.hpp"

#include "complaint.hpp"
#include "paths.hpp"

namespace graspless::robot {

inline const Robot& wam() {
  static const auto robot = Robot::from_urdf_file(urdf_file("wam_t42.urdf"));
  return robot;
}

inline const Robot& kr5() {
  static const auto robot = Robot::from_urdf_file(urdf_file("kr5_t42.urdf"));
  return robot;
}

/// Three revolute joints about skew axes, one that slides, one that turns without end, and two that
/// follow others: joint "echo" the joint "mirror", which follows "first".
inline Robot oddity() { return Robot::from_urdf_file(data_file("oddity.urdf")); }

/// Uniform within the limits.
inline Eigen::VectorXd random_q(const Robot& robot, std::mt19937_64& rng) {
  std::uniform_real_distribution<double> unit(0, 1);
  const Eigen::VectorXd u = Eigen::VectorXd::NullaryExpr(robot.dof(), [&] { return unit(rng); });
  return robot.lower() + u.cwiseProduct(robot.upper() - robot.lower());
}

inline double distance(const Eigen::Isometry3d& X, const Eigen::Isometry3d& Y) {
  return (X.matrix() - Y.matrix()).cwiseAbs().maxCoeff();
}

}  // namespace graspless::robot

#define EXPECT_CONTAINS(text, part)               \
  EXPECT_NE((text).find(part), std::string::npos) \
      << "'" << (text) << "' does not say '" << (part) << "'"
