// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/shape.hpp"

namespace graspless::collision {

/// A triangle, ready to be asked for distances.
struct SurfaceTriangle {
  Eigen::Vector3d a, ab, ac;
  Eigen::Vector3d middle;  ///< of a sphere around it
  double radius;           ///< of that sphere [m]
};

/// The triangles of a mesh. One thinner than 1e-9 m is given that width, for a distance needs its
/// normal.
std::vector<SurfaceTriangle> surface_triangles(const geometry::Mesh& mesh);

/// From p to the triangle.
double squared_distance(const SurfaceTriangle& triangle, const Eigen::Vector3d& p);

}  // namespace graspless::collision
