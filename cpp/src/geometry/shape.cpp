// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/shape.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "geometry/convex_hull.hpp"
#include "geometry/require_points.hpp"

namespace graspless::geometry {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& fault) {
  throw std::invalid_argument(what + " " + fault);
}

void require_length(double value, const std::string& what) {
  if (value >= kMinLength && value <= kMaxLength) return;
  std::ostringstream fault;
  fault << "must be in [" << kMinLength << ", " << kMaxLength << "] m, not " << value;
  refuse(what, fault.str());
}

void check(const Box& box, const std::string& what) {
  for (int axis = 0; axis < 3; ++axis) {
    require_length(box.size[axis], what + ".size[" + std::to_string(axis) + "]");
  }
}

void check(const Sphere& sphere, const std::string& what) {
  require_length(sphere.radius, what + ".radius");
}

void check(const Capsule& capsule, const std::string& what) {
  require_length(capsule.radius, what + ".radius");
  require_length(capsule.length, what + ".length");
}

void check(const Convex& convex, const std::string& what) {
  if (convex.vertices.cols() < 4) {
    refuse(what + ".vertices",
           "must be four points or more, not " + std::to_string(convex.vertices.cols()));
  }
  require_points(convex.vertices, what + ".vertices");
  if (!spans_volume(convex.vertices)) {
    refuse(what + ".vertices", "must span a volume, but lie in a plane");
  }
}

void check(const Mesh& mesh, const std::string& what) {
  const Eigen::Index count = mesh.vertices.cols();
  if (mesh.triangles.cols() == 0) refuse(what + ".triangles", "must not be empty");
  require_points(mesh.vertices, what + ".vertices");
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    const auto triangle = mesh.triangles.col(i);
    if (triangle.minCoeff() >= 0 && triangle.maxCoeff() < count) continue;
    std::ostringstream fault;
    fault << "must be indices of the " << count << " vertices, but column " << i << " is ("
          << triangle.transpose() << ")";
    refuse(what + ".triangles", fault.str());
  }
}

/// Extent of a shape centred at its frame along d, a unit vector of that frame [m].
struct Extent {
  Eigen::Vector3d d;
  double operator()(const Box& box) const { return d.cwiseAbs().dot(box.size) / 2; }
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Capsule& c) const { return c.radius + std::abs(d.z()) * c.length / 2; }
  double operator()(const Convex& hull) const { return (d.transpose() * hull.vertices).maxCoeff(); }
  double operator()(const Mesh& mesh) const { return (d.transpose() * mesh.vertices).maxCoeff(); }
};

}  // namespace

void validate(const Shape& shape, const std::string& what) {
  std::visit([&](const auto& kind) { check(kind, what); }, shape);
}

double extent(const PlacedShape& placed, const Eigen::Vector3d& direction_B) {
  const Eigen::Vector3d direction_G = placed.X_BG.linear().transpose() * direction_B;
  return direction_B.dot(placed.X_BG.translation()) + std::visit(Extent{direction_G}, placed.shape);
}

}  // namespace graspless::geometry
