// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lower bounds on the distance of two shapes, from the box that each fills or sits in.
#pragma once

#include <string>

#include <Eigen/Geometry>

namespace graspless::collision {

/// Every shape lies within `radius` of a box that is centred and aligned in its frame C. A sphere
/// is such a box without size, a capsule one without width: these two are exact.
struct Core {
  Eigen::Vector3d half = Eigen::Vector3d::Zero();  ///< half the box's sides [m]
  double radius = 0;                               ///< [m]
  bool is_exact_segment = false;                   ///< the shape is a sphere or a capsule
};

/// Where a shape is: the frame of its core, and half the sides of its axis-aligned box in the
/// world.
struct Placement {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  Eigen::Vector3d half_W = Eigen::Vector3d::Zero();
};

/// Whether X is finite, turns without stretching more than rounding does, and moves by at most
/// geometry::kMaxLength.
bool is_pose(const Eigen::Isometry3d& X);

/// Throws std::invalid_argument that names `what` unless is_pose(X).
void require_pose(const Eigen::Isometry3d& X, const std::string& what);

/// Half the sides of the axis-aligned box of a core that is turned by R_WC.
Eigen::Vector3d half_in_world(const Core& core, const Eigen::Matrix3d& R_WC);

/// Gap between two boxes that share their axes, from centre to centre `offset`; 0 when they
/// overlap.
inline double box_gap(const Eigen::Vector3d& offset, const Eigen::Vector3d& half_sum) {
  return (offset.cwiseAbs() - half_sum).cwiseMax(0.0).norm();
}

/// The distance of two segments with middles m and half axes h.
double segment_distance(const Eigen::Vector3d& m_a, const Eigen::Vector3d& h_a,
                        const Eigen::Vector3d& m_b, const Eigen::Vector3d& h_b);

/// A lower bound on the distance of shape a from shape b, the latter moved by `shift_W`: from the
/// box of each core in the other's frame, or exact when both are spheres or capsules. Negative when
/// they may overlap.
double oriented_bound(const Core& a, const Placement& at_a, const Core& b, const Placement& at_b,
                      const Eigen::Vector3d& shift_W);

/// The better of oriented_bound and the gap of the axis-aligned boxes, at least 0.
double shape_distance_bound(const Core& a, const Placement& at_a, const Core& b,
                            const Placement& at_b, const Eigen::Vector3d& shift_W);

}  // namespace graspless::collision
