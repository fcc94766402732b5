// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lower bounds on the distance of two shapes, from a box that each fills or lies in.
#pragma once

#include <string>

#include <Eigen/Geometry>

namespace graspless::collision {

/// A box, centred and aligned in the shape's frame C, such that the shape lies within `radius` of
/// it. For a sphere the box is a point, for a capsule a segment: these two are exact.
struct Core {
  Eigen::Vector3d half = Eigen::Vector3d::Zero();  ///< half the box's sides [m]
  double radius = 0;                               ///< [m]
  bool is_exact_segment = false;                   ///< the shape is a sphere or a capsule
};

/// Pose of a shape's core, and half the sides of its axis-aligned box in the world.
struct Placement {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  Eigen::Vector3d half_W = Eigen::Vector3d::Zero();
};

/// Returns half the sides of the axis-aligned box of a core that is rotated by R_WC.
Eigen::Vector3d half_in_world(const Core& core, const Eigen::Matrix3d& R_WC);

/// Distance between two boxes with the same axes, whose centres are `offset` apart; 0 if they
/// overlap.
inline double box_gap(const Eigen::Vector3d& offset, const Eigen::Vector3d& half_sum) {
  return (offset.cwiseAbs() - half_sum).cwiseMax(0.0).norm();
}

/// Returns the distance of two segments with midpoints m and half axes h.
double segment_distance(const Eigen::Vector3d& m_a, const Eigen::Vector3d& h_a,
                        const Eigen::Vector3d& m_b, const Eigen::Vector3d& h_b);

/// Returns a lower bound on the distance of shape a and shape b moved by `shift_W`: from the box of
/// each core in the other's frame, or exact if both are spheres or capsules. Negative if they may
/// overlap.
double oriented_bound(const Core& a, const Placement& at_a, const Core& b, const Placement& at_b,
                      const Eigen::Vector3d& shift_W);

/// Returns the larger of oriented_bound and the distance of the axis-aligned boxes, at least 0. The
/// latter alone if that is `enough`.
double shape_distance_bound(const Core& a, const Placement& at_a, const Core& b,
                            const Placement& at_b, const Eigen::Vector3d& shift_W, double enough);

}  // namespace graspless::collision
