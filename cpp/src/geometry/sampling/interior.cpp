// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sampling/interior.hpp"

#include <algorithm>

#include "geometry/convex_hull.hpp"

namespace graspless::geometry {

Interior::Interior(const PlacedShape& placed) : X_GB_(placed.X_BG.inverse()) {
  std::visit([this](const auto& shape) { set(shape); }, placed.shape);
}

bool Interior::contains(const Eigen::Vector3d& p_B) const {
  const Eigen::Vector3d p_G = X_GB_ * p_B;
  if (p_G.squaredNorm() >= reach_ * reach_) return false;
  if (radius_ > 0) {
    const double z = p_G.z() - std::clamp(p_G.z(), -half_length_, half_length_);
    return p_G.head<2>().squaredNorm() + z * z < radius_ * radius_;
  }
  return ((normals_ * p_G).array() < offsets_.array()).all();
}

void Interior::set(const Box& box) {
  reach_ = box.size.norm() / 2;
  normals_.resize(6, 3);
  normals_ << Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity();
  offsets_.resize(6);
  offsets_ << box.size / 2, box.size / 2;
}

void Interior::set(const Convex& convex) {
  reach_ = convex.vertices.colwise().norm().maxCoeff();
  const Mesh hull = convex_hull(convex.vertices);
  normals_.resize(hull.triangles.cols(), 3);
  offsets_.resize(hull.triangles.cols());
  for (Eigen::Index i = 0; i < hull.triangles.cols(); ++i) {
    const Eigen::Vector3d a = hull.vertices.col(hull.triangles(0, i));
    const Eigen::Vector3d b = hull.vertices.col(hull.triangles(1, i));
    const Eigen::Vector3d c = hull.vertices.col(hull.triangles(2, i));
    normals_.row(i) = (b - a).cross(c - a).stableNormalized();
    offsets_[i] = normals_.row(i).dot(a);
  }
}

void Interior::set_round(double radius, double half_length) {
  reach_ = radius + half_length;
  radius_ = radius;
  half_length_ = half_length;
}

}  // namespace graspless::geometry
