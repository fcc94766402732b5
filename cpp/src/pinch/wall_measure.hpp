// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <Eigen/Core>

#include "graspless/geometry/height_map.hpp"

namespace graspless::pinch {

/// Tangents by which a face leans: a pad touches all of one, and the other with its end alone.
constexpr double kUpright = 0.1, kLeaning = 0.3;

/// The wall between two contacts, measured along fine lines across it. Arrays have one value for
/// the side of each contact.
struct WallMeasure {
  bool is_wall = false;            ///< it reaches half a pad above the contacts all along the pads
  std::array<double, 2> beyond{};  ///< how far it goes on behind the contact [m]
  std::array<double, 2> friction{};  ///< tangent of the angle between closing and the normal
  /// How far the middle of a contact is above the middle of its pad: the face was not seen further
  /// down, or leans, and the pad touches it with its end [m].
  double rise = 0;
};

/// True if the face at the side of a contact is where the contact is, within a cell [m].
bool fits(const WallMeasure& wall, std::size_t side, double cell);

/// Measures the wall between the contacts (3 x 2, of one height, in O) of pads that reach `patch`
/// [m] to all sides of them.
WallMeasure measure_wall(const geometry::HeightMap& map,
                         const Eigen::Matrix<double, 3, 2>& contacts_O, double patch);

}  // namespace graspless::pinch
