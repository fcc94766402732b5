// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/obstacle.hpp"
#include "graspless/export.hpp"
#include "graspless/robot/robot.hpp"
#include "graspless/slide/hand.hpp"
#include "graspless/slide/object.hpp"
#include "graspless/slide/support.hpp"

namespace graspless::slide {

using collision::Obstacle;  // neither the arm nor the sliding object may touch one

/// The task: slide `object` from X_WO_start to an edge of `support` and grasp it there; or to
/// X_WO_end, and leave it there.
struct Problem {
  robot::Robot robot;
  Hand hand;
  Object object;
  Support support;
  Eigen::Isometry3d X_WO_start = Eigen::Isometry3d::Identity();  ///< flat on the support
  std::vector<Obstacle> obstacles;
  Eigen::VectorXd q_home;  ///< configuration at the start, all joints [rad or m]
  std::optional<Eigen::Isometry3d> X_WO_end =
      {};  ///< where the object is left, flat on the support
};

/// Throws std::invalid_argument that names the field, its value and what is allowed: unknown links,
/// groups or states; a q_home outside the joint limits; an object that is not flat on the support
/// (2 mm, 1 degree) or whose centre of mass is off it, at X_WO_start or at X_WO_end; finger
/// dimensions out of range; and where it is slid, fingers that close less than it is thick.
GRASPLESS_API void validate(const Problem& problem, bool is_slid = true);

}  // namespace graspless::slide
