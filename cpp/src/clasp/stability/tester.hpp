// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "graspless/clasp/problem.hpp"
#include "graspless/clasp/stability.hpp"
#include "graspless/collision/clearance.hpp"

#include "clasp/hand/kinematics.hpp"
#include "clasp/stability/balls.hpp"

namespace graspless::clasp {

/// test_stability for many configurations of one problem. Not shared between threads.
class StabilityTester {
 public:
  explicit StabilityTester(const Problem& problem);

  /// `loop`: corners, in O. Options must be valid and q a configuration of the robot.
  Stability test(const Eigen::VectorXd& q, const Eigen::Matrix3Xd& loop_O,
                 const StabilityOptions& options);

 private:
  Eigen::Isometry3d X_OW_;
  HandKinematics kinematics_;
  LinkBalls balls_;
  collision::Clearance clearance_;
};

}  // namespace graspless::clasp
