// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/clearance_triangles.hpp"

#include <algorithm>

#include "graspless/watch.hpp"

namespace graspless::collision {
namespace {

using Eigen::Vector3d;

constexpr double kMinWidth = 1e-9;  // [m]

SurfaceTriangle surface_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d middle = (a + b + c) / 3;
  const double radius = std::max({(a - middle).norm(), (b - middle).norm(), (c - middle).norm()});
  return {a, b - a, c - a, middle, radius};
}

SurfaceTriangle with_width(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d corners[] = {a, b, c};
  int first = 0;  // first corner of the longest side
  double length = 0;
  for (int i = 0; i < 3; ++i) {
    const double side = (corners[(i + 1) % 3] - corners[i]).norm();
    if (side > length) {
      length = side;
      first = i;
    }
  }
  if (length < kMinWidth) {
    return surface_triangle(a, a + kMinWidth * Vector3d::UnitX(),
                            a + kMinWidth * Vector3d::UnitY());
  }
  if ((b - a).cross(c - a).norm() >= kMinWidth * length) return surface_triangle(a, b, c);
  // Degenerate: the ends of the longest side, and a corner beside its midpoint.
  const Vector3d &from = corners[first], &to = corners[(first + 1) % 3];
  return surface_triangle(from, to, (from + to) / 2 + kMinWidth * (to - from).unitOrthogonal());
}

}  // namespace

std::vector<SurfaceTriangle> surface_triangles(const geometry::Mesh& mesh) {
  std::vector<SurfaceTriangle> triangles;
  triangles.reserve(mesh.triangles.cols());
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    poll();
    const auto corners = mesh.triangles.col(i);
    triangles.push_back(with_width(mesh.vertices.col(corners[0]), mesh.vertices.col(corners[1]),
                                   mesh.vertices.col(corners[2])));
  }
  return triangles;
}

/// Classifies the region of the plane that p projects into (Ericson, Real-Time Collision Detection,
/// 5.1.5).
double squared_distance(const SurfaceTriangle& triangle, const Vector3d& p) {
  const Vector3d &ab = triangle.ab, &ac = triangle.ac;
  const Vector3d ap = p - triangle.a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return ap.squaredNorm();
  const Vector3d bp = ap - ab;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return bp.squaredNorm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - d1 / (d1 - d3) * ab).squaredNorm();
  const Vector3d cp = ap - ac;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return cp.squaredNorm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - d2 / (d2 - d6) * ac).squaredNorm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double along = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return (bp - along * (ac - ab)).squaredNorm();
  }
  const double scale = 1 / (va + vb + vc);
  return (ap - vb * scale * ab - vc * scale * ac).squaredNorm();
}

}  // namespace graspless::collision
