// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/link_shapes.hpp"

#include <cmath>
#include <stdexcept>

#include "graspless/watch.hpp"

#include "text.hpp"

namespace graspless::robot {
namespace {

using Eigen::Vector3d;
using geometry::PlacedShape;

constexpr double kCapsuleTolerance =
    1e-6;  // between radius and position of sphere and cylinder [m]
constexpr int kPrismSides = 24;

/// Reads a mesh; says where it was looked for.
geometry::Mesh read_mesh_of(const urdf::Mesh& mesh, const Robot::Options& options) {
  const Vector3d scale(mesh.scale.x, mesh.scale.y, mesh.scale.z);
  const std::string path = mesh_path(mesh.filename, {"", "", options.packages, options.directory});
  try {
    return geometry::read_mesh(path, scale);
  } catch (const std::invalid_argument& error) {
    if (path == mesh.filename) throw;
    throw std::invalid_argument("'" + mesh.filename + "': " + error.what());
  }
}

/// A circumscribed prism: whatever is free of the prism is free of the cylinder.
geometry::Convex prism(const urdf::Cylinder& cylinder) {
  const double radius = cylinder.radius / std::cos(M_PI / kPrismSides);
  Eigen::Matrix3Xd vertices(3, 2 * kPrismSides);
  for (int i = 0; i < kPrismSides; ++i) {
    const double angle = 2 * M_PI * i / kPrismSides;
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    vertices.col(2 * i) = Vector3d(x, y, -cylinder.length / 2);
    vertices.col(2 * i + 1) = Vector3d(x, y, cylinder.length / 2);
  }
  return {vertices};
}

void check_cylinder(const urdf::Cylinder& cylinder, const std::string& what) {
  for (const double length : {cylinder.radius, cylinder.length}) {
    if (std::isfinite(length) && length > 0) continue;
    throw std::invalid_argument(what + ": radius and length of a cylinder must be positive, not " +
                                figure(cylinder.radius) + " and " + figure(cylinder.length));
  }
}

geometry::Shape to_shape(const urdf::Geometry& shape, const Robot::Options& options) {
  if (shape.type == urdf::Geometry::BOX) {
    const auto& size = static_cast<const urdf::Box&>(shape).dim;
    return geometry::Box{Vector3d(size.x, size.y, size.z)};
  }
  if (shape.type == urdf::Geometry::SPHERE) {
    return geometry::Sphere{static_cast<const urdf::Sphere&>(shape).radius};
  }
  if (shape.type == urdf::Geometry::CYLINDER) {
    return prism(static_cast<const urdf::Cylinder&>(shape));
  }
  return read_mesh_of(static_cast<const urdf::Mesh&>(shape), options);
}

/// Finds the capsules among the collision elements of a link, and the spheres that belong to them.
class CapsuleFinder {
 public:
  explicit CapsuleFinder(const urdf::Link& link)
      : link_(link), used_(link.collision_array.size()) {}

  bool is_capsule(const urdf::Collision& element) {
    if (element.geometry->type != urdf::Geometry::CYLINDER) return false;
    const auto& cylinder = static_cast<const urdf::Cylinder&>(*element.geometry);
    const Eigen::Isometry3d X_LG = to_isometry(element.origin);
    const Spheres bottom =
        find_spheres(X_LG * Vector3d(0, 0, -cylinder.length / 2), cylinder.radius);
    const Spheres top = find_spheres(X_LG * Vector3d(0, 0, cylinder.length / 2), cylinder.radius);
    if (bottom.empty() || top.empty()) return false;
    for (const std::size_t i : bottom) used_[i] = true;
    for (const std::size_t i : top) used_[i] = true;
    return true;
  }

  bool is_used(std::size_t element) const { return used_[element]; }

 private:
  using Spheres = std::vector<std::size_t>;

  /// A sphere may serve two capsules that share an end.
  Spheres find_spheres(const Vector3d& p_LS, double radius) const {
    Spheres found;
    poll();
    for (std::size_t i = 0; i < used_.size(); ++i) {
      const urdf::Collision& element = *link_.collision_array[i];
      if (element.geometry->type != urdf::Geometry::SPHERE) continue;
      const double other = static_cast<const urdf::Sphere&>(*element.geometry).radius;
      const Vector3d p_LO = to_isometry(element.origin).translation();
      if (std::abs(other - radius) <= kCapsuleTolerance &&
          (p_LO - p_LS).norm() <= kCapsuleTolerance) {
        found.push_back(i);
      }
    }
    return found;
  }

  const urdf::Link& link_;
  std::vector<bool> used_;
};

PlacedShape place(const urdf::Collision& element, bool is_capsule, const Robot::Options& options,
                  const std::string& what) {
  PlacedShape placed{geometry::Sphere{0}, to_isometry(element.origin)};
  if (element.geometry->type == urdf::Geometry::CYLINDER) {
    check_cylinder(static_cast<const urdf::Cylinder&>(*element.geometry), what);
  }
  if (is_capsule) {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(*element.geometry);
    placed.shape = geometry::Capsule{cylinder.radius, cylinder.length};
  } else {
    try {
      placed.shape = to_shape(*element.geometry, options);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(what + ": " + error.what());
    }
  }
  geometry::validate(placed.shape, what);
  return placed;
}

}  // namespace

Eigen::Isometry3d to_isometry(const urdf::Pose& pose) {
  const auto& p = pose.position;
  const auto& r = pose.rotation;
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  X.translation() = Vector3d(p.x, p.y, p.z);
  return X;
}

std::vector<PlacedShape> link_shapes(const urdf::Link& link, const Robot::Options& options) {
  const auto& elements = link.collision_array;
  CapsuleFinder capsules(link);
  std::vector<bool> is_capsule;
  for (const auto& element : elements) is_capsule.push_back(capsules.is_capsule(*element));
  const std::string what = "collision shape of link '" + link.name + "'";
  std::vector<PlacedShape> shapes;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (!capsules.is_used(i)) shapes.push_back(place(*elements[i], is_capsule[i], options, what));
  }
  return shapes;
}

}  // namespace graspless::robot
