// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include <Eigen/Geometry>

namespace graspless::geometry {

/// Returns the smallest rotation that turns the z axis onto a direction of any length. Eigen's own
/// function is a singular value decomposition, which takes seconds to compile wherever it is used.
Eigen::Quaterniond turn_from_z(const Eigen::Vector3d& direction);

/// Largest distance between the points to which two rotations turn a point at distance 1 from the
/// origin: the largest singular value of their difference, which is its norm / sqrt(2).
inline double most_apart(const Eigen::Matrix3d& R1, const Eigen::Matrix3d& R2) {
  return (R1 - R2).norm() / M_SQRT2;
}

}  // namespace graspless::geometry
