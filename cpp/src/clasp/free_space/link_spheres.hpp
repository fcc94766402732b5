// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Spheres around and inside the links of a robot, for fast distance bounds.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/shape.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::clasp {

/// A node of a link's tree of bounding spheres. The sphere of radius `outer` contains the spheres
/// of its leaves. The leaves together cover the link.
struct LinkSphere {
  Eigen::Vector3d p_L;  ///< centre, in the link's frame [m]
  double outer;         ///< radius of the bounding sphere [m]
  double inner;         ///< radius of a sphere inside the link [m]; negative: none
  int next;  ///< first node after the subtree; the first child directly follows its parent
};

/// Nodes of one link in depth-first order; empty for a link without shapes.
using SphereTree = std::vector<LinkSphere>;

/// Builds one tree per link, in the order of Robot::frame_names().
std::vector<SphereTree> link_spheres(const robot::Robot& robot);

struct Sphere {
  Eigen::Vector3d center;
  double radius;
};

/// A shape in the frame of its link: spheres that cover it, and a function for the depth of a point
/// inside [m] (negative or zero: not known to be inside).
struct CoveredShape {
  std::vector<Sphere> spheres;
  std::function<double(const Eigen::Vector3d&)> depth;
};

/// Interior of a mesh.
enum class MeshInside {
  hollow,  ///< none, as in collision tests, unless the mesh is closed and convex
  hull,    ///< its convex hull
};

/// Covers a shape with spheres.
CoveredShape covered(const geometry::PlacedShape& placed, MeshInside inside);

/// Builds the tree over the spheres of several shapes in one frame.
SphereTree sphere_tree(const std::vector<CoveredShape>& shapes);

}  // namespace graspless::clasp
