// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/shape.hpp"

/// What the sample objects are put together from.
namespace graspless::clasp {

using Parts = std::vector<geometry::PlacedShape>;
using Points = std::vector<Eigen::Vector3d>;

/// A round bar along a polyline: a capsule a stretch.
Parts bar(const Points& points, double radius);

/// The inside of a handle: an upside-down U that stands on the plane z = 0 in the plane y = 0.
struct Arch {
  double width, height;  ///< clear [m]
  double corner;         ///< radius of the two upper corners, of the clear space [m]
  double radius;         ///< of the bar [m]
  double root;           ///< how far the bar goes on below z = 0 [m]
};
Parts arch(const Arch& arch);

geometry::PlacedShape box(const Eigen::Vector3d& size, const Eigen::Vector3d& p_OG);
/// Between two horizontal rectangles about the z axis: size (x, y) and height of each.
geometry::PlacedShape wedge(const Eigen::Vector2d& lower_size, double lower,
                            const Eigen::Vector2d& upper_size, double upper);
/// A hull of points on the ellipsoid.
geometry::PlacedShape ellipsoid(const Eigen::Vector3d& half_axes, const Eigen::Vector3d& p_OG);
/// A wheel: its axis along y.
geometry::PlacedShape disc(double radius, double width, const Eigen::Vector3d& p_OG);

Parts moved(Parts parts, const Eigen::Vector3d& by);
void append(Parts& parts, const Parts& more);

/// The five, at real size.
Parts make_purse();
Parts make_bag();
Parts make_travel_bag();
Parts make_lawn_mower();
Parts make_chair();

}  // namespace graspless::clasp
