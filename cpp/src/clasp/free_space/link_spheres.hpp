// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Spheres around and inside the links of a robot.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/shape.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::clasp {

/// A node of a link's tree of spheres. The sphere of radius `outer` holds what of the link its
/// children's hold; the root's holds the whole link, and the leaves' together do.
struct LinkSphere {
  Eigen::Vector3d p_L;  ///< centre, in the link's frame [m]
  double outer;         ///< [m]
  double inner;         ///< this much around the centre is solid link; negative: none [m]
  int next;             ///< the node after the subtree; the next in line is the first child
};

/// The nodes of one link, a parent before its children; empty for a link without shapes.
using SphereTree = std::vector<LinkSphere>;

/// One tree a link, indexed as Robot::frame_names().
std::vector<SphereTree> link_spheres(const robot::Robot& robot);

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
