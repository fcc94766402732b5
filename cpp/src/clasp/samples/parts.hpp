// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/shape.hpp"

/// Building blocks of the sample objects.
namespace graspless::clasp {

using Parts = std::vector<geometry::PlacedShape>;
using Points = std::vector<Eigen::Vector3d>;

/// A round bar along a polyline: one capsule per segment.
Parts bar(const Points& points, double radius);

/// A handle: an upside-down U in the plane y = 0 that stands on the plane z = 0.
struct Arch {
  double width, height;  ///< of the opening [m]
  double corner;         ///< radius of the upper corners of the opening [m]
  double radius;         ///< of the bar [m]
  double root;           ///< length of the bar below z = 0 [m]
};
Parts arch(const Arch& arch);

geometry::PlacedShape box(const Eigen::Vector3d& size, const Eigen::Vector3d& p_OG);
/// Convex hull of two horizontal rectangles centred on the z axis, with sizes (x, y) and heights.
geometry::PlacedShape wedge(const Eigen::Vector2d& lower_size, double lower,
                            const Eigen::Vector2d& upper_size, double upper);
/// Convex hull of points on an ellipsoid.
geometry::PlacedShape ellipsoid(const Eigen::Vector3d& half_axes, const Eigen::Vector3d& p_OG);
/// A wheel with its axis along y.
geometry::PlacedShape disc(double radius, double width, const Eigen::Vector3d& p_OG);

Parts moved(Parts parts, const Eigen::Vector3d& by);
void append(Parts& parts, const Parts& more);

/// The sample objects, at real size.
Parts make_purse();
Parts make_bag();
Parts make_travel_bag();
Parts make_lawn_mower();
Parts make_chair();

}  // namespace graspless::clasp
