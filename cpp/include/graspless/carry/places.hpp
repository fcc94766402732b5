// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace graspless::carry {

/// Places on an obstacle where a held object may be put down.
struct Places {
  std::vector<Eigen::Isometry3d> X_WO;  ///< poses of the object there, the best first
  std::string on;                       ///< obstacle on which the object then stands
  Eigen::Vector3d normal_W = Eigen::Vector3d::UnitZ();  ///< unit normal of its surface
  /// Configuration whose joints outside the arm's group open the hand, all joints [rad or m].
  Eigen::VectorXd q_open;
  /// Configurations along which the hand can leave the object, the first with the hand open around
  /// it, all joints [rad or m]: the hand leaves it along the same way relative to the object, and
  /// with the same fingers. Empty: it goes straight, and stays open.
  std::vector<Eigen::VectorXd> way_out = {};
  /// Direction in O in which the object comes down, of any length: that in which a loose object
  /// sinks in the hand, so that its bottom stands still from the first touch on. Zero: straight
  /// down, against normal_W.
  Eigen::Vector3d down_O = Eigen::Vector3d::Zero();
};

}  // namespace graspless::carry
