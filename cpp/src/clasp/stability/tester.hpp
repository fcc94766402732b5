// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "graspless/clasp/problem.hpp"
#include "graspless/clasp/stability.hpp"
#include "graspless/collision/clearance.hpp"

#include "clasp/hand/kinematics.hpp"
#include "clasp/stability/balls.hpp"
#include "clasp/stability/load.hpp"

namespace graspless::clasp {

/// Stability test for many configurations of one problem. Not thread-safe.
class StabilityTester {
 public:
  explicit StabilityTester(const Problem& problem);

  /// Runs the test for a loop, 3 x n in O [m]. q and the options must be valid.
  Stability test(const Eigen::VectorXd& q, const Eigen::Matrix3Xd& loop_O,
                 const StabilityOptions& options);

 private:
  Problem problem_;
  Eigen::Isometry3d X_OW_;
  HandKinematics kinematics_;
  LinkBalls balls_;
  collision::Clearance clearance_;
  std::optional<LoadTester> load_;  // made with the first load on a hand of two fingers
};

}  // namespace graspless::clasp
