// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A polyhedron and what the planner asks of it.
#include "graspless/fingertip/object.hpp"

#include <stdexcept>
#include <utility>

#include "graspless/mechanics/contact.hpp"

#include "fingertip/model/mesh.hpp"
#include "geometry/box_mesh.hpp"
#include "geometry/convex_hull.hpp"
#include "text.hpp"

namespace graspless::fingertip {
namespace {

std::string called(const std::string& name) { return "object '" + name + "'"; }

/// Without what is rounding only: symmetric objects are to have symmetric properties.
template <typename Matrix>
Matrix cleaned(const Matrix& values, double scale) {
  return (values.array().abs() < 1e-14 * scale).select(Matrix::Zero(), values);
}

}  // namespace

Object::Object(std::string name, geometry::Mesh mesh, double mass)
    : name_(std::move(name)),
      mesh_(std::move(mesh)),
      mass_(mass),
      solid_({{mesh_, Eigen::Isometry3d::Identity()}}, called(name_)) {
  const geometry::Mesh hull = geometry::convex_hull(mesh_.vertices);
  hull_ = hull.vertices;
  is_convex_ = geometry::is_convex(mesh_, hull);
  size_ = (hull_.rowwise().maxCoeff() - hull_.rowwise().minCoeff()).norm();
  faces_ = find_faces(mesh_, size_);
  const MassProperties uniform = mass_properties(mesh_);
  com_ = cleaned(uniform.center, size_);
  inertia_ = mass / uniform.volume * uniform.inertia;
  inertia_ = cleaned(inertia_, inertia_.cwiseAbs().maxCoeff());
}

Object Object::box(const std::string& name, const Eigen::Vector3d& size, double mass) {
  geometry::validate(geometry::Box{size}, called(name));
  return from_mesh(name, geometry::box_mesh(size), mass);
}

Object Object::from_mesh(const std::string& name, const geometry::Mesh& mesh, double mass) {
  require_within(called(name) + " mass", mass, mechanics::kMinMass, mechanics::kMaxMass, " kg");
  return Object(name, closed_mesh(mesh, called(name) + " mesh"), mass);
}

Object Object::with_com(const Eigen::Vector3d& com_O) const {
  const Eigen::Matrix4Xd planes = geometry::half_spaces(geometry::convex_hull(hull_));
  const auto beyond = com_O.transpose() * planes.topRows<3>() - planes.row(3);
  if (!com_O.allFinite() || beyond.maxCoeff() > 1e-9 * size_) {
    throw std::invalid_argument(called(name_) + " com (" + figure(com_O.x()) + ", " +
                                figure(com_O.y()) + ", " + figure(com_O.z()) +
                                ") must lie within the convex hull");
  }
  Object other = *this;
  other.com_ = com_O;
  return other;
}

Object Object::with_inertia(const Eigen::Matrix3d& inertia_O) const {
  mechanics::wrench_scale(mass_, inertia_O);  // refuses what is no inertia
  Object other = *this;
  other.inertia_ = inertia_O;
  return other;
}

}  // namespace graspless::fingertip
