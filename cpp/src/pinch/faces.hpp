// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/polygon.hpp"

namespace graspless::pinch {

constexpr double kPi = 3.14159265358979323846;

/// Two opposite parts of an outline, between which a jaw fits.
struct Faces {
  double yaw;                     ///< of the closing direction [rad]
  Eigen::Vector2d first, second;  ///< contacts: the second lies along the closing direction
  double width;                   ///< distance between two lines that enclose both parts [m]
  double friction;                ///< tangent of the larger angle between closing and a normal
  double lever;                   ///< distance of the centre of mass from the line of contacts [m]
  Eigen::Vector2d middle() const { return (first + second) / 2; }
};

/// Returns the opposite parts of an outline, `pad` [m] long, in directions 5 degrees apart. A noisy
/// outline counts with the line that fits it best along the pad.
std::vector<Faces> opposite_faces(const geometry::Polygon& outline, const Eigen::Vector2d& com,
                                  double pad);

}  // namespace graspless::pinch
