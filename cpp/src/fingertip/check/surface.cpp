// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(): whether a contact lies on the object's surface.
#include <algorithm>

#include "fingertip/check/check.hpp"

namespace graspless::fingertip::checking {
namespace {

double distance_to_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b) {
  const Eigen::Vector3d ab = b - a;
  const double t = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-300), 0.0, 1.0);
  return (a + t * ab - p).norm();
}

/// From a point to a triangle with the unit normal n: straight down where the foot falls inside,
/// else to the nearest side.
double distance_to_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d (&corner)[3],
                            const Eigen::Vector3d& n) {
  bool inside = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d &a = corner[i], &b = corner[(i + 1) % 3];
    inside = inside && (b - a).cross(p - a).dot(n) >= 0;
    nearest = std::min(nearest, distance_to_segment(p, a, b));
  }
  return inside ? std::abs(n.dot(p - corner[0])) : nearest;
}

}  // namespace

bool is_on_surface(const geometry::Mesh& mesh, const Eigen::Vector3d& p_O,
                   const Eigen::Vector3d& n_O, double tolerance) {
  constexpr double kSameNormal = 1e-6;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Eigen::Vector3i corners = mesh.triangles.col(t);
    const Eigen::Vector3d corner[3] = {mesh.vertices.col(corners[0]), mesh.vertices.col(corners[1]),
                                       mesh.vertices.col(corners[2])};
    const Eigen::Vector3d n =
        (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();  // outward
    if ((n + n_O).norm() > kSameNormal) continue;
    if (distance_to_triangle(p_O, corner, n) <= tolerance) return true;
  }
  return false;
}

}  // namespace graspless::fingertip::checking
