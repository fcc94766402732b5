// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/height_map.hpp"

#include "pinch/faces.hpp"

namespace graspless::pinch {

/// Returns the parts of walls, `length` [m] long, in directions 5 degrees apart, that reach `above`
/// [m] over contacts at some heights [m]. A wall is a run of cells that are higher than the
/// contacts, between lower ones. The friction counts both slopes of a face: along the wall, and
/// upwards. `above` is half the height of the pads.
std::vector<Faces> walls(const geometry::HeightMap& map, const Eigen::Vector3d& com, double length,
                         const std::vector<double>& heights, double above);

/// Both pads of a hand.
struct Pads {
  double friction;     ///< coefficient on the object, mu
  double press;        ///< force of each, F [N]
  double half;         ///< half length of its contact, a [m]
  double share = 0.5;  ///< part of the weight that the contact with more of it bears, p
};

/// Largest mass that two pads hold by a wall [kg]. The weight W, at a lever l along the wall and an
/// offset d across it, must be within all that the contacts bear:
///   force and twist  (W p / ((mu - s) F))^2 + (W l / (4/3 mu a F))^2 <= 1
///   tilt             W d <= (a - r) F, half of what contacts bear that are even
/// where s is what the slopes of the faces take of the friction.
/// A centre of mass below the contacts lets the object swing a little, which makes l and d shorter.
/// Where a face leans, or nobody saw it as low as the pads reach, a contact is shorter, and r
/// higher.
double largest_mass(const Faces& faces, const Pads& pads);

}  // namespace graspless::pinch
