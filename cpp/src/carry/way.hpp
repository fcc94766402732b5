// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "graspless/carry/carry.hpp"

namespace graspless::carry {

/// The straight way of the object: positions on a line, attitudes about one axis, both evenly.
class Way {
 public:
  Way(const Eigen::Isometry3d& X_WO_start, const Eigen::Isometry3d& X_WO_goal);

  double distance() const { return along_.norm(); }  ///< [m]
  double angle() const { return turn_.angle(); }     ///< [rad]
  /// The pose a part s of the way, turned by `twist` about the line of the way through O.
  Eigen::Isometry3d pose(double s, double twist) const;
  /// Whether a pose lies on the way, at its own place and with any twist within `max_twist`.
  bool holds(const Eigen::Isometry3d& X_WO, const Options& options) const;

 private:
  Eigen::Isometry3d start_;
  Eigen::Vector3d along_;   // from start to goal, in W
  Eigen::Vector3d axis_;    // of the twist, in W
  Eigen::AngleAxisd turn_;  // from start to goal, in O at the start
};

}  // namespace graspless::carry
