// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth images of known scenes, as truth for tests and trials.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"
#include "graspless/perception/camera.hpp"

namespace graspless::perception {

/// A body of a rendered scene: boxes, convex hulls and meshes in its frame B.
struct Body {
  std::vector<geometry::PlacedShape> shapes;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< pose in the world
};

/// First hits of the rays through the centres of all pixels.
struct Rendering {
  DepthImage depth;   ///< [m]; 0 if a ray meets nothing
  LabelImage label;   ///< index of the body; -1 if a ray meets nothing
  DepthImage cosine;  ///< of the angle between the ray and the surface's normal, in [0, 1]
};

/// Casts one ray per pixel, with CGAL's AABB trees. Throws std::invalid_argument that names the
/// field on a bad camera, pose or shape, and on spheres and capsules, which have no triangles.
GRASPLESS_API Rendering render(const std::vector<Body>& bodies, const Eigen::Isometry3d& X_WC,
                               const Camera& camera = {});

}  // namespace graspless::perception
