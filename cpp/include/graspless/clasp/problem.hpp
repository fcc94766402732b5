// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/clasp/hand.hpp"
#include "graspless/clasp/object.hpp"
#include "graspless/collision/obstacle.hpp"
#include "graspless/export.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::clasp {

using collision::Obstacle;

/// What is given: put the hand through a hole of `object` and close it.
struct Problem {
  robot::Robot robot;
  Hand hand;
  Object object;
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  std::vector<Obstacle> obstacles;
  Eigen::VectorXd q_start;  ///< where the robot stands, all joints [rad or m]
  /// Which loops may be clasped, as indices of object.loops().loops; empty: any.
  std::vector<int> loops;
  /// Where to clasp: the places of the loops nearest to these points, in O [m]; empty: anywhere.
  std::vector<Eigen::Vector3d> marks;
  /// Where the object shall be pulled once it is clasped, in W: the loop and the places that are
  /// good for it are tried first, those where the object would turn away are left out.
  std::optional<Eigen::Vector3d> pull_W;
};

/// Throws std::invalid_argument that names the field, the value and the choices.
GRASPLESS_API void validate(const Problem& problem);

}  // namespace graspless::clasp
