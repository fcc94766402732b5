// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// A loop that runs around a thick handle has the inside of the handle at its centre, where almost
// every ray hits the object. From the centre of a hole, most rays miss it.
#include <cmath>

#include <Eigen/Geometry>

#include "graspless/watch.hpp"

#include "geometry/loops/shortest_basis.hpp"

namespace graspless::geometry {
namespace {

constexpr int kRays = 160;
constexpr int kMaxOpenRays = kRays / 10;  // from a centre that is inside

/// Directions spread evenly over the sphere (Fibonacci spiral), in an order whose first few are
/// also spread evenly.
Eigen::Matrix3Xd directions() {
  constexpr double kGolden = 2.39996322972865332;
  constexpr int kStride = 63;  // has no factor in common with kRays
  Eigen::Matrix3Xd rays(3, kRays);
  for (int i = 0; i < kRays; ++i) {
    const double z = 1 - (2 * i + 1.0) / kRays, r = std::sqrt(1 - z * z);
    rays.col(i * kStride % kRays) << r * std::cos(kGolden * i), r * std::sin(kGolden * i), z;
  }
  return rays;
}

/// True if at most kMaxOpenRays rays are not blocked. Most cases end after a few open rays.
template <class IsBlocked>
bool most_rays_blocked(const IsBlocked& is_blocked) {
  static const Eigen::Matrix3Xd rays = directions();
  int num_open = 0;
  for (int i = 0; i < kRays; ++i) {
    poll();
    if (!is_blocked(rays.col(i)) && ++num_open > kMaxOpenRays) return false;
  }
  return true;
}

/// True if most rays pass a point within `near`. A cheap necessary condition: every point of a
/// triangle is that close to one of its corners.
bool most_rays_pass_points(const Complex& complex, const Eigen::Vector3d& middle, double near) {
  const Eigen::Matrix3Xd points = complex.points.colwise() - middle;
  const Eigen::RowVectorXd squares = points.colwise().squaredNorm();
  return most_rays_blocked([&](const Eigen::Vector3d& ray) {
    const Eigen::RowVectorXd along = ray.transpose() * points;
    const auto is_ahead = along.array() > 0;
    const auto is_near = squares.array() - along.array().square() <= near * near;
    return (is_ahead && is_near).any();
  });
}

/// True if a ray hits a triangle (Moeller, Trumbore 1997).
bool hits(const Eigen::Vector3d& from, const Eigen::Vector3d& ray, const Eigen::Vector3d& a,
          const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, normal = ray.cross(ac);
  const double det = ab.dot(normal);
  if (det == 0) return false;
  const Eigen::Vector3d to = from - a;
  const double u = to.dot(normal) / det;
  if (u < 0 || u > 1) return false;
  const Eigen::Vector3d q = to.cross(ab);
  const double v = ray.dot(q) / det;
  return v >= 0 && u + v <= 1 && ac.dot(q) / det > 0;
}

bool most_rays_hit_triangles(const Complex& complex, const Eigen::Vector3d& middle) {
  return most_rays_blocked([&](const Eigen::Vector3d& ray) {
    for (Eigen::Index t = 0; t < complex.triangles.cols(); ++t) {
      const auto corner = complex.triangles.col(t);
      if (hits(middle, ray, complex.points.col(corner[0]), complex.points.col(corner[1]),
               complex.points.col(corner[2]))) {
        return true;
      }
    }
    return false;
  });
}

}  // namespace

std::vector<bool> find_meridians(const Complex& complex, const std::vector<Cycle>& basis) {
  std::vector<bool> is_meridian;
  for (const Cycle& cycle : basis) {
    const Eigen::Vector3d middle = complex.points(Eigen::all, cycle).rowwise().mean();
    is_meridian.push_back(
        most_rays_pass_points(complex, middle, complex.max_edge_length / std::sqrt(3)) &&
        most_rays_hit_triangles(complex, middle));
  }
  return is_meridian;
}

}  // namespace graspless::geometry
