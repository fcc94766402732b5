// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"

namespace graspless::geometry {

/// Largest length or coordinate [m]. Beyond 1e6 m the collision library may loop forever.
constexpr double kMaxLength = 1e4;
/// Smallest length that must be positive, such as a radius [m].
constexpr double kMinLength = 1e-6;

/// Box centred at its frame's origin, sides along the axes.
struct Box {
  Eigen::Vector3d size;  ///< side lengths [m]
};

/// Sphere centred at its frame's origin.
struct Sphere {
  double radius;  ///< [m]
};

/// All points within `radius` of the segment from (0, 0, -length/2) to (0, 0, length/2).
struct Capsule {
  double radius;  ///< [m]
  double length;  ///< length of the segment, without the two half spheres [m]
};

/// The convex hull of a set of points.
struct Convex {
  Eigen::Matrix3Xd vertices;  ///< one point per column [m]
};

/// A triangle surface. One that is closed bounds a solid: what is wholly inside touches it. Of any
/// other, only the surface collides.
struct Mesh {
  Eigen::Matrix3Xd vertices;   ///< one point per column [m]
  Eigen::Matrix3Xi triangles;  ///< vertex indices, one triangle per column
};

using Shape = std::variant<Box, Sphere, Capsule, Convex, Mesh>;

/// A shape fixed in the frame of a body B.
struct PlacedShape {
  Shape shape;
  Eigen::Isometry3d X_BG = Eigen::Isometry3d::Identity();  ///< pose of the shape's frame G in B
};

/// Throws std::invalid_argument that names `what` unless every length is at least kMinLength,
/// nothing exceeds kMaxLength, a hull has at least four points and spans a volume, and every
/// triangle index refers to a vertex of its mesh.
GRASPLESS_API void validate(const Shape& shape, const std::string& what);

/// Support function of a shape: its largest coordinate along a unit direction of B, from B's origin
/// [m]; minus infinity for a hull or mesh without vertices.
GRASPLESS_API double extent(const PlacedShape& placed, const Eigen::Vector3d& direction_B);

/// Largest padding of a shape [m], and most triangles of the meshes of a body that gets one.
constexpr double kMaxPadding = 0.5;
constexpr int kMaxPaddedTriangles = 5000;

/// Returns shapes that contain every point within `padding` [m] of the given ones. They reach
/// farther by less than 1.26 times the padding, at the corners of a box by up to 1.74 times.
/// Spheres and capsules are exact. Of a mesh, each triangle gives a hull.
GRASPLESS_API std::vector<PlacedShape> grown(const std::vector<PlacedShape>& shapes,
                                             double padding);

/// Reads a triangle mesh from .stl, .obj, .off or .ply (see set_mesh_reader() for others) and
/// scales it per axis. Polygons are triangulated. Throws std::invalid_argument that names the path
/// if the file is missing, unreadable or empty.
GRASPLESS_API Mesh read_mesh(const std::string& path,
                             const Eigen::Vector3d& scale = Eigen::Vector3d::Ones());

/// Reads a file in metres; throws std::invalid_argument that names the path.
using MeshReader = std::function<Mesh(const std::string& path)>;

/// Sets the function with which read_mesh() reads .dae, .glb and .gltf, which it refuses otherwise.
/// Must be called before other threads read meshes. The Python package sets one.
GRASPLESS_API void set_mesh_reader(MeshReader reader);

}  // namespace graspless::geometry
