// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/openness.hpp"

#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "graspless/watch.hpp"

namespace graspless::geometry {
namespace {

constexpr int kRays = 256;

/// Directions spread evenly over the sphere (Fibonacci spiral), as rows.
using Rays = Eigen::Matrix<double, kRays, 3>;

Rays make_rays() {
  constexpr double kGolden = 2.39996322972865332;
  Rays rays;
  for (int i = 0; i < kRays; ++i) {
    const double z = 1 - (2 * i + 1.0) / kRays, r = std::sqrt(1 - z * z);
    rays.row(i) << r * std::cos(kGolden * i), r * std::sin(kGolden * i), z;
  }
  return rays;
}

/// True if a ray from the origin hits a triangle (Moeller, Trumbore 1997).
bool hits(const Eigen::Vector3d& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& ab,
          const Eigen::Vector3d& ac) {
  const Eigen::Vector3d normal = ray.cross(ac);
  const double det = ab.dot(normal);
  if (det == 0) return false;
  const double u = -a.dot(normal) / det;
  if (u < 0 || u > 1) return false;
  const Eigen::Vector3d q = ab.cross(a);
  const double v = ray.dot(q) / det;
  return v >= 0 && u + v <= 1 && ac.dot(q) / det > 0;
}

}  // namespace

Openness openness(const Complex& complex, const Eigen::Vector3d& middle,
                  const Eigen::Vector3d& normal) {
  static const Rays rays = make_rays();
  const Eigen::Matrix3Xd points = complex.points.colwise() - middle;
  Eigen::Array<bool, kRays, 1> is_blocked = Eigen::Array<bool, kRays, 1>::Zero();
  for (Eigen::Index t = 0; t < complex.triangles.cols(); ++t) {
    if (t % 64 == 0) poll();
    const auto corner = complex.triangles.col(t);
    const Eigen::Vector3d a = points.col(corner[0]), b = points.col(corner[1]),
                          c = points.col(corner[2]);
    // A cone about the triangle decides which rays are tested.
    const Eigen::Vector3d mean = (a + b + c) / 3;
    const double distance = mean.norm();
    const double radius = std::sqrt(
        std::max({(a - mean).squaredNorm(), (b - mean).squaredNorm(), (c - mean).squaredNorm()}));
    double least = -1;  // cosine
    if (radius < distance) least = std::sqrt(1 - radius * radius / (distance * distance));
    const Eigen::Array<double, kRays, 1> along = (rays * (mean / distance)).array();
    for (int i = 0; i < kRays; ++i) {
      if (along[i] < least || is_blocked[i]) continue;
      is_blocked[i] = hits(rays.row(i), a, b - a, c - a);
    }
  }
  std::array<int, 2> open{}, all{};
  for (int i = 0; i < kRays; ++i) {
    const std::size_t side = rays.row(i).dot(normal) > 0 ? 0 : 1;
    ++all[side];
    open[side] += !is_blocked[i];
  }
  return {static_cast<double>(open[0]) / std::max(1, all[0]),
          static_cast<double>(open[1]) / std::max(1, all[1])};
}

}  // namespace graspless::geometry
