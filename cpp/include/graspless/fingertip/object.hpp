// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/solid.hpp"
#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::fingertip {

/// A flat part of an object's surface.
struct Face {
  Eigen::Vector3d n_O;  ///< into the object, unit
  /// Grid axes on the face, unit: first as mechanics::tangent(n_O, 0), second = n_O x first.
  Eigen::Vector3d first_O, second_O;
  double offset = 0;           ///< n_O . p of its points [m]
  std::vector<int> triangles;  ///< columns of Object::mesh().triangles
  double area = 0;             ///< [m^2]
};

/// A rigid polyhedron to be moved: any closed mesh, convex or not, in a frame O of the caller's
/// choice.
class GRASPLESS_API Object {
 public:
  /// A box centred at O, sides along the axes [m], of uniform density.
  static Object box(const std::string& name, const Eigen::Vector3d& size, double mass);
  /// A closed mesh of uniform density. An inverted one is turned outward. Throws
  /// std::invalid_argument, naming `name`, when it is not closed or not oriented throughout,
  /// has no volume or more than kMaxTriangles triangles, or the mass is not positive.
  static Object from_mesh(const std::string& name, const geometry::Mesh& mesh, double mass);
  static constexpr int kMaxTriangles = 200000;

  /// The same object with another centre of mass [m], or inertia about it [kg m^2], both in O.
  /// Throws unless the centre lies within the convex hull and mechanics::wrench_scale takes the
  /// inertia.
  Object with_com(const Eigen::Vector3d& com_O) const;
  Object with_inertia(const Eigen::Matrix3d& inertia_O) const;

  const std::string& name() const { return name_; }
  const geometry::Mesh& mesh() const { return mesh_; }       ///< closed, outward
  const std::vector<Face>& faces() const { return faces_; }  ///< coplanar neighbours joined
  const Eigen::Matrix3Xd& hull() const { return hull_; }     ///< corners of the convex hull [m]
  bool is_convex() const { return is_convex_; }
  double mass() const { return mass_; }                        ///< [kg]
  const Eigen::Vector3d& com() const { return com_; }          ///< in O [m]
  const Eigen::Matrix3d& inertia() const { return inertia_; }  ///< about com, in O [kg m^2]
  double size() const { return size_; }                        ///< diagonal of the hull's box [m]
  const collision::Solid& solid() const { return solid_; }

 private:
  Object(std::string name, geometry::Mesh mesh, double mass);
  std::string name_;
  geometry::Mesh mesh_;
  std::vector<Face> faces_;
  Eigen::Matrix3Xd hull_;
  bool is_convex_ = false;
  double mass_ = 0;
  Eigen::Vector3d com_;
  Eigen::Matrix3d inertia_;
  double size_ = 0;
  collision::Solid solid_;
};

}  // namespace graspless::fingertip
