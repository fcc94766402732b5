// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/polygon.hpp"

namespace graspless::pinch {

/// Two opposite parts of an outline or of a wall, between which a jaw fits.
struct Faces {
  double yaw;                     ///< of the closing direction [rad]
  Eigen::Vector2d first, second;  ///< contacts: the second lies along the closing direction
  double width;                   ///< distance between two lines that enclose both parts [m]
  double friction;                ///< tangent of the larger angle between closing and a normal
  double lever;                   ///< distance of the centre of mass from the line of contacts [m]
  double offset = 0;              ///< of the centre of mass from their middle, along that line [m]
  double drop = 0;                ///< of the centre of mass below the contacts [m]
  /// How far the pads' contacts may be above the middle of the pads, because nobody saw a face
  /// lower down [m].
  double rise = 0;
  std::optional<double> max_mass = std::nullopt;  ///< largest that the pads hold there [kg]
  double load = 0;                                ///< mass of the object, relative to max_mass
  std::optional<double> height = std::nullopt;    ///< of the contacts, where the faces have one [m]
  Eigen::Vector2d middle() const { return (first + second) / 2; }
};

/// Returns the opposite parts of an outline, `pad` [m] long, in directions 5 degrees apart. A noisy
/// outline counts with the line that fits it best along the pad.
std::vector<Faces> opposite_faces(const geometry::Polygon& outline, const Eigen::Vector2d& com,
                                  double pad);

}  // namespace graspless::pinch
