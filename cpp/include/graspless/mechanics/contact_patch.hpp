// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"
#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

/// Solid half-space that the object rests on or leans against: a floor or a wall.
struct Plane {
  std::string name = "floor";
  Eigen::Vector3d n_W = Eigen::Vector3d::UnitZ();  ///< out of the solid, unit
  double offset = 0;                               ///< n_W . p of its surface points [m]
  double friction = 0.5;                           ///< coefficient, in [0, 10000]
};

/// Pose and velocity of an object at one instant.
struct BodyState {
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  /// Velocity of O's origin, then angular velocity, in W per unit of the motion's parameter.
  Vector6d twist_W = Vector6d::Zero();
  /// True if the object stands still, for instance while fingers regrasp. Then every contact
  /// sticks, and the twist only determines the directions of the cones.
  bool at_rest = false;
};

/// Contacts of a polyhedron with planes.
struct ContactPatches {
  /// Vertices of the convex hulls of the patches, in O. The first edge of a sticking contact's cone
  /// points along the velocity of the centre of mass over the plane.
  std::vector<Contact> contacts;
  std::vector<int> plane;  ///< index of each contact's plane
  /// Reason why the vertices do not represent the patches; empty if they do. A face or an edge
  /// turns about an axis that would lift or drive in part of it, a vertex moves into a plane, or
  /// the object penetrates a plane.
  std::string fault;
  /// True if a face turns about its normal while it slides. Its vertices alone then understate the
  /// wrenches that friction can exert.
  bool turns_in_plane = false;
};

/// Finds the contacts of the convex hull of `vertices_O` (3 x n [m]) with the planes. A vertex
/// within `tolerance` [m] of a plane touches it. A touching vertex that leaves its plane is
/// ignored, one that moves along it slides, and one that does not move sticks. Throws
/// std::invalid_argument on bad arguments.
GRASPLESS_API ContactPatches contact_patches(const Eigen::Matrix3Xd& vertices_O,
                                             const Eigen::Vector3d& com_O,
                                             const std::vector<Plane>& planes,
                                             const BodyState& state, double tolerance);

}  // namespace graspless::mechanics
