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

/// A clasp planning problem: put the hand through a hole of `object` and close it.
struct Problem {
  robot::Robot robot;
  Hand hand;
  Object object;
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  std::vector<Obstacle> obstacles;
  Eigen::VectorXd q_start;  ///< start configuration of all joints [rad or m]
  /// Loops that may be clasped, as indices of object.loops().found; empty: all.
  std::vector<int> loops = {};
  /// Points in O [m]. The hand clasps at the loop points nearest to them; empty: anywhere.
  std::vector<Eigen::Vector3d> marks = {};
  /// Direction in W in which the clasped object will be pulled. Targets where the hand would slip
  /// or the object would turn round are excluded. The others are tried in order of suitability.
  std::optional<Eigen::Vector3d> pull_W = {};
};

/// Throws std::invalid_argument that names the field, the value and the choices.
GRASPLESS_API void validate(const Problem& problem);

}  // namespace graspless::clasp
