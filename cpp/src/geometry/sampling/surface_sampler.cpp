// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sampling/surface_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/box_mesh.hpp"
#include "geometry/convex_hull.hpp"

namespace graspless::geometry {
namespace {

constexpr double kFullTurn = 6.283185307179586;  // [rad]

Eigen::Vector3d corner(const Mesh& mesh, Eigen::Index triangle, int k) {
  return mesh.vertices.col(mesh.triangles(k, triangle));
}

Eigen::Vector3d twice_area(const Mesh& mesh, Eigen::Index triangle) {
  const Eigen::Vector3d a = corner(mesh, triangle, 0);
  return (corner(mesh, triangle, 1) - a).cross(corner(mesh, triangle, 2) - a);
}

}  // namespace

SurfaceSampler::SurfaceSampler(const PlacedShape& placed) : X_BG_(placed.X_BG) {
  std::visit([this](const auto& shape) { set(shape); }, placed.shape);
}

SurfaceSampler::Point SurfaceSampler::draw(std::mt19937_64& rng) const {
  Point point = radius_ > 0 ? draw_round(rng) : draw_triangle(rng);
  point.p_B = X_BG_ * point.p_B;
  point.outward_B = X_BG_.linear() * point.outward_B;
  return point;
}

void SurfaceSampler::set(const Box& box) { set(Convex{box_mesh(box.size).vertices}); }

void SurfaceSampler::set(const Convex& convex) {
  set(convex_hull(convex.vertices));
  has_outside_ = true;
}

void SurfaceSampler::set(const Mesh& mesh) {
  mesh_ = mesh;
  has_outside_ = false;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    area_ += twice_area(mesh, i).norm() / 2;
    cumulative_area_.push_back(area_);
  }
}

void SurfaceSampler::set_round(double radius, double length) {
  radius_ = radius;
  length_ = length;
  area_ = kFullTurn * radius * (length + 2 * radius);
}

// Between two heights, a sphere has the same area as the cylinder around it (Archimedes). So one
// uniform draw along the axis covers the cylinder and both caps.
SurfaceSampler::Point SurfaceSampler::draw_round(std::mt19937_64& rng) const {
  const double height = length_ / 2 + radius_;
  const double z = height * (2 * draw_uniform(rng) - 1);
  const double z_axis = std::clamp(z, -length_ / 2, length_ / 2);
  const double along = (z - z_axis) / radius_;
  const double across = std::sqrt(std::max(0.0, 1 - along * along));
  const double angle = kFullTurn * draw_uniform(rng);
  const Eigen::Vector3d outward(across * std::cos(angle), across * std::sin(angle), along);
  return {Eigen::Vector3d(0, 0, z_axis) + radius_ * outward, outward};
}

SurfaceSampler::Point SurfaceSampler::draw_triangle(std::mt19937_64& rng) const {
  const auto at = std::upper_bound(cumulative_area_.begin(), cumulative_area_.end() - 1,
                                   area_ * draw_uniform(rng));
  const Eigen::Index i = at - cumulative_area_.begin();
  double u = draw_uniform(rng), v = draw_uniform(rng);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const Eigen::Vector3d a = corner(mesh_, i, 0);
  Point point{a + u * (corner(mesh_, i, 1) - a) + v * (corner(mesh_, i, 2) - a),
              Eigen::Vector3d::Zero()};
  if (has_outside_) point.outward_B = twice_area(mesh_, i).stableNormalized();
  return point;
}

}  // namespace graspless::geometry
