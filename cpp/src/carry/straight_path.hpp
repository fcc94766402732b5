// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "graspless/carry/carry.hpp"

namespace graspless::carry {

/// The object's straight path: its origin moves along a line while its attitude turns about one
/// axis, both at constant rates.
class StraightPath {
 public:
  StraightPath(const Eigen::Isometry3d& X_WO_start, const Eigen::Isometry3d& X_WO_goal);

  double distance() const { return along_.norm(); }  ///< [m]
  double angle() const { return turn_.angle(); }     ///< [rad]
  /// Pose at fraction s of the path, in [0, 1], turned by `twist` [rad] about the path's line
  /// through O.
  Eigen::Isometry3d pose(double s, double twist) const;
  /// True if a pose lies on the path, at any s and with any twist up to `max_twist`.
  bool contains(const Eigen::Isometry3d& X_WO, const Options& options) const;

 private:
  Eigen::Isometry3d start_;
  Eigen::Vector3d along_;   // from start to goal, in W
  Eigen::Vector3d axis_;    // of the twist, in W
  Eigen::AngleAxisd turn_;  // from start to goal, in O at the start
};

}  // namespace graspless::carry
