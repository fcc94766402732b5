// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// A loop that runs around a thick handle has the handle's inside in its middle: from there, every
// way out is barred. From the middle of a hole, most are open.
#include <cmath>

#include <Eigen/Geometry>

#include "geometry/loops/shortest_basis.hpp"

namespace graspless::geometry {
namespace {

constexpr int kRays = 160;
constexpr int kMostOpen = kRays / 10;  // where the middle is inside

/// Directions spread evenly over the sphere (a Fibonacci spiral), and so are the first few of them.
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

/// Whether all but kMostOpen of the rays are barred. The first ones that are not settle most cases.
template <class IsBarred>
bool most_are(const IsBarred& is_barred) {
  static const Eigen::Matrix3Xd rays = directions();
  int num_open = 0;
  for (int i = 0; i < kRays; ++i) {
    if (!is_barred(rays.col(i)) && ++num_open > kMostOpen) return false;
  }
  return true;
}

/// Whether most rays come by a point within `near`: no more can be barred, since every place of a
/// triangle is that near to a corner.
bool most_come_near_points(const Complex& complex, const Eigen::Vector3d& middle, double near) {
  const Eigen::Matrix3Xd points = complex.points.colwise() - middle;
  const Eigen::RowVectorXd squares = points.colwise().squaredNorm();
  return most_are([&](const Eigen::Vector3d& ray) {
    const Eigen::RowVectorXd along = ray.transpose() * points;
    const auto is_ahead = along.array() > 0;
    const auto is_near = squares.array() - along.array().square() <= near * near;
    return (is_ahead && is_near).any();
  });
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

bool most_meet_triangles(const Complex& complex, const Eigen::Vector3d& middle) {
  return most_are([&](const Eigen::Vector3d& ray) {
    for (Eigen::Index t = 0; t < complex.triangles.cols(); ++t) {
      const auto corner = complex.triangles.col(t);
      if (meets(middle, ray, complex.points.col(corner[0]), complex.points.col(corner[1]),
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
        most_come_near_points(complex, middle, complex.max_edge_length / std::sqrt(3)) &&
        most_meet_triangles(complex, middle));
  }
  return is_meridian;
}

}  // namespace graspless::geometry
