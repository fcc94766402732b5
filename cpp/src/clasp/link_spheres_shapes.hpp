// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/shape.hpp"

#include "clasp/link_spheres.hpp"

namespace graspless::clasp {

struct Sphere {
  Eigen::Vector3d center;
  double radius;
};

/// A shape in the frame of its link: spheres that cover it, and how deep a point lies inside
/// (negative or zero: not known to be inside) [m].
struct CoveredShape {
  std::vector<Sphere> spheres;
  std::function<double(const Eigen::Vector3d&)> depth;
};

/// What a mesh counts as inside.
enum class MeshInside {
  hollow,  ///< nothing: collision tests see the surface, unless the mesh is closed and convex
  hull,    ///< its convex hull
};

CoveredShape covered(const geometry::PlacedShape& placed, MeshInside inside);

/// The tree over the spheres of several shapes in one frame.
SphereTree sphere_tree(const std::vector<CoveredShape>& shapes);

}  // namespace graspless::clasp
