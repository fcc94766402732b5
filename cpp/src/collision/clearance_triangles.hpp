// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/shape.hpp"

namespace graspless::collision {

/// A triangle, prepared for distance queries.
struct SurfaceTriangle {
  Eigen::Vector3d a, ab, ac;
  Eigen::Vector3d middle;  ///< centre of a bounding sphere
  double radius;           ///< radius of that sphere [m]
};

/// Returns the triangles of a mesh. A triangle thinner than 1e-9 m is widened to that, because
/// distances need its normal.
std::vector<SurfaceTriangle> surface_triangles(const geometry::Mesh& mesh);

/// Squared distance from p to the triangle [m^2].
double squared_distance(const SurfaceTriangle& triangle, const Eigen::Vector3d& p);

}  // namespace graspless::collision
