// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// A loop that runs around a thick handle has the handle's inside in its middle: from there, every
// way out is barred. From the middle of a hole, most are open.
#include <cmath>

#include <Eigen/Geometry>

#include "geometry/shortest_basis.hpp"

namespace graspless::geometry {
namespace {

constexpr int kRays = 160;
constexpr double kBarred = 0.9;  // of the rays, where the middle is inside

/// Directions spread evenly over the sphere (a Fibonacci spiral).
Eigen::Matrix3Xd directions() {
  constexpr double kGolden = 2.39996322972865332;
  Eigen::Matrix3Xd rays(3, kRays);
  for (int i = 0; i < kRays; ++i) {
    const double z = 1 - (2 * i + 1.0) / kRays, r = std::sqrt(1 - z * z);
    rays.col(i) << r * std::cos(kGolden * i), r * std::sin(kGolden * i), z;
  }
  return rays;
}

/// The share of rays that come by a point within `near`: no more can be barred, since every place
/// of a triangle is that near to a corner.
double share_near_points(const Complex& complex, const Eigen::Vector3d& middle, double near) {
  const Eigen::Matrix3Xd rays = directions();
  const Eigen::Matrix3Xd points = complex.points.colwise() - middle;
  const Eigen::RowVectorXd squares = points.colwise().squaredNorm();
  int count = 0;
  for (int i = 0; i < kRays; ++i) {
    const Eigen::RowVectorXd along = rays.col(i).transpose() * points;
    const auto is_ahead = along.array() > 0;
    const auto is_near = squares.array() - along.array().square() <= near * near;
    if ((is_ahead && is_near).any()) ++count;
  }
  return static_cast<double>(count) / kRays;
}

/// Whether a ray meets a triangle (Moeller, Trumbore 1997).
bool meets(const Eigen::Vector3d& from, const Eigen::Vector3d& ray, const Eigen::Vector3d& a,
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

double share_barred(const Complex& complex, const Eigen::Vector3d& middle) {
  const Eigen::Matrix3Xd rays = directions();
  int count = 0;
  for (int i = 0; i < kRays; ++i) {
    bool is_barred = false;
    for (Eigen::Index t = 0; t < complex.triangles.cols() && !is_barred; ++t) {
      const auto corner = complex.triangles.col(t);
      is_barred = meets(middle, rays.col(i), complex.points.col(corner[0]),
                        complex.points.col(corner[1]), complex.points.col(corner[2]));
    }
    if (is_barred) ++count;
  }
  return static_cast<double>(count) / kRays;
}

}  // namespace

std::vector<bool> find_meridians(const Complex& complex, const std::vector<Cycle>& basis) {
  std::vector<bool> is_meridian;
  for (const Cycle& cycle : basis) {
    const Eigen::Vector3d middle = complex.points(Eigen::all, cycle).rowwise().mean();
    is_meridian.push_back(
        share_near_points(complex, middle, complex.max_edge_length / std::sqrt(3)) >= kBarred &&
        share_barred(complex, middle) >= kBarred);
  }
  return is_meridian;
}

}  // namespace graspless::geometry
