// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"

namespace graspless::geometry {

/// No length or coordinate may be larger [m]: beyond 1e6 the collision library's loops need not
/// end.
constexpr double kMaxLength = 1e4;

/// Centred at its frame's origin, sides along the axes.
struct Box {
  Eigen::Vector3d size;  ///< side lengths [m]
};

/// Centred at its frame's origin.
struct Sphere {
  double radius;  ///< [m]
};

/// All points within `radius` of the segment from (0, 0, -length/2) to (0, 0, length/2).
struct Capsule {
  double radius;  ///< [m]
  double length;  ///< of the segment, without the two half spheres [m]
};

/// The convex hull of a set of points.
struct Convex {
  Eigen::Matrix3Xd vertices;  ///< one point a column [m]
};

/// A triangle surface. Only the surface collides, so that a body wholly inside does not touch it;
/// but a closed convex one collides as the solid it bounds.
struct Mesh {
  Eigen::Matrix3Xd vertices;   ///< one point a column [m]
  Eigen::Matrix3Xi triangles;  ///< columns of vertex indices
};

using Shape = std::variant<Box, Sphere, Capsule, Convex, Mesh>;

/// A shape fixed in the frame of a body B.
struct PlacedShape {
  Shape shape;
  Eigen::Isometry3d X_BG = Eigen::Isometry3d::Identity();  ///< pose of the shape's frame G in B
};

/// Throws std::invalid_argument, naming `what`, unless every length is positive, nothing exceeds
/// kMaxLength, a hull has four points that span a volume, and every triangle index is one of the
/// mesh's vertices.
GRASPLESS_API void validate(const Shape& shape, const std::string& what);

/// How far a shape reaches along a unit direction of B, seen from B's origin (its support function)
/// [m].
GRASPLESS_API double extent(const PlacedShape& placed, const Eigen::Vector3d& direction_B);

/// Reads a triangle mesh (.stl, .obj, .off, .ply; polygons are triangulated) and scales it per
/// axis. Throws std::invalid_argument that names the path when it is missing, unreadable or empty.
GRASPLESS_API Mesh read_mesh(const std::string& path,
                             const Eigen::Vector3d& scale = Eigen::Vector3d::Ones());

}  // namespace graspless::geometry
