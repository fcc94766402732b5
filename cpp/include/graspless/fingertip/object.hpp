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

/// Planar face of an object.
struct Face {
  Eigen::Vector3d n_O;  ///< unit normal, into the object
  /// Unit vectors of the grid axes along the face: first = mechanics::tangent(n_O, 0), second =
  /// n_O x first.
  Eigen::Vector3d first_O, second_O;
  double offset = 0;           ///< n_O . p of the points p on the face [m]
  std::vector<int> triangles;  ///< columns of Object::mesh().triangles
  double area = 0;             ///< [m^2]
};

/// Rigid polyhedron to be moved: any closed mesh, convex or not, in a frame O of the caller's
/// choice.
class GRASPLESS_API Object {
 public:
  /// Returns a box of uniform density, centred at O. `size`: side lengths along the axes [m].
  static Object box(const std::string& name, const Eigen::Vector3d& size, double mass);
  /// Returns an object of uniform density from a closed mesh. An inverted mesh is turned outward,
  /// but a single piece that is inverted must bound a cavity of another one.
  /// Throws std::invalid_argument that names `name` if the mesh is not closed, not consistently
  /// oriented, has no volume or more than kMaxTriangles triangles, or if the mass is not positive.
  static Object from_mesh(const std::string& name, const geometry::Mesh& mesh, double mass);
  static constexpr int kMaxTriangles = 200000;

  /// Returns a copy with another centre of mass [m], or another inertia about it [kg m^2], both in
  /// O. Throws std::invalid_argument unless the centre of mass lies within the convex hull and
  /// mechanics::wrench_scale() accepts the inertia.
  Object with_com(const Eigen::Vector3d& com_O) const;
  Object with_inertia(const Eigen::Matrix3d& inertia_O) const;

  const std::string& name() const { return name_; }
  const geometry::Mesh& mesh() const { return mesh_; }       ///< closed, with outward triangles
  const std::vector<Face>& faces() const { return faces_; }  ///< coplanar triangles are one face
  const Eigen::Matrix3Xd& hull() const { return hull_; }     ///< vertices of the convex hull [m]
  bool is_convex() const { return is_convex_; }
  double mass() const { return mass_; }                        ///< [kg]
  const Eigen::Vector3d& com() const { return com_; }          ///< in O [m]
  const Eigen::Matrix3d& inertia() const { return inertia_; }  ///< about com, in O [kg m^2]
  double size() const { return size_; }                        ///< diagonal of the bounding box [m]
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
