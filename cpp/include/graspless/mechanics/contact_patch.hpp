// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"
#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

/// A half-space that the object rests on or leans against: floor or wall.
struct Plane {
  std::string name = "floor";
  Eigen::Vector3d n_W = Eigen::Vector3d::UnitZ();  ///< out of the solid, unit
  double offset = 0;                               ///< n_W . p of its points [m]
  double friction = 0.5;                           ///< coefficient
};

/// How an object stands and moves at one instant.
struct BodyState {
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  /// Of the object in W per unit of the motion's parameter: velocity of O's origin, then omega.
  Vector6d twist_W = Vector6d::Zero();
  /// Whether the object stands still (while fingers regrasp, say): every contact sticks, and the
  /// twist only turns the cones.
  bool at_rest = false;
};

/// Where a polyhedron touches planes.
struct ContactPatches {
  /// The vertices of the patches' convex hulls, in O. The first edge of a sticking contact's cone
  /// lies along the velocity of the centre of mass over the plane.
  std::vector<Contact> contacts;
  std::vector<int> plane;  ///< of each contact
  /// Why the vertices cannot stand for the patches; empty when they can. A face or an edge that
  /// turns about an axis which it cannot follow, a vertex that moves into a plane, a penetration.
  std::string fault;
  /// A face turns about its normal while it slides: its vertices understate what friction can do.
  bool turns_in_plane = false;
};

/// Contacts of the convex hull of `vertices_O` (3 x n [m]) with the planes. A vertex within
/// `tolerance` [m] of a plane touches it; of those one that leaves its plane does not count, one
/// that moves along it slides, one that does not move sticks.
GRASPLESS_API ContactPatches contact_patches(const Eigen::Matrix3Xd& vertices_O,
                                             const Eigen::Vector3d& com_O,
                                             const std::vector<Plane>& planes,
                                             const BodyState& state, double tolerance);

}  // namespace graspless::mechanics
