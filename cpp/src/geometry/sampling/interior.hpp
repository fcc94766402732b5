// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {

/// Point-in-shape test. A mesh has no inside.
class Interior {
 public:
  explicit Interior(const PlacedShape& placed);

  bool contains(const Eigen::Vector3d& p_B) const;

 private:
  using Planes = Eigen::Matrix<double, Eigen::Dynamic, 3>;

  void set(const Box& box);
  void set(const Sphere& sphere) { set_round(sphere.radius, 0); }
  void set(const Capsule& capsule) { set_round(capsule.radius, capsule.length / 2); }
  void set(const Convex& convex);
  void set(const Mesh&) {}
  void set_round(double radius, double half_length);

  Eigen::Isometry3d X_GB_;
  double reach_ = 0;  // radius about the origin of G that contains the shape [m]
  double radius_ = 0, half_length_ = 0;
  Planes normals_;           // outward
  Eigen::VectorXd offsets_;  // inside: normals * p < offsets
};

}  // namespace graspless::geometry
