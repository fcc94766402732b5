// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {
namespace {

struct Extent {
  Eigen::Vector3d d;  // in the shape's frame
  double operator()(const Box& box) const { return d.cwiseAbs().dot(box.size) / 2; }
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Capsule& c) const { return c.radius + std::abs(d.z()) * c.length / 2; }
  double operator()(const Convex& hull) const { return (d.transpose() * hull.vertices).maxCoeff(); }
  double operator()(const Mesh& mesh) const { return (d.transpose() * mesh.vertices).maxCoeff(); }
};

}  // namespace

double extent(const PlacedShape& placed, const Eigen::Vector3d& direction_B) {
  const Eigen::Vector3d direction_G = placed.X_BG.linear().transpose() * direction_B;
  return direction_B.dot(placed.X_BG.translation()) + std::visit(Extent{direction_G}, placed.shape);
}

}  // namespace graspless::geometry
