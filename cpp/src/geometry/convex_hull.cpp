// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/convex_hull.hpp"

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

namespace graspless::geometry {
namespace {

// Exact predicates make the hull of coplanar and nearly coplanar points right; no point is
// constructed.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

// Relative, between two sums of the same size.
constexpr double kVolumeTolerance = 1e-9;

double signed_volume(const Mesh& mesh, const Eigen::Vector3d& p_origin) {
  double volume = 0;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    const auto corner = [&](int k) -> Eigen::Vector3d {
      return mesh.vertices.col(mesh.triangles(k, i)) - p_origin;
    };
    volume += corner(0).cross(corner(1)).dot(corner(2)) / 6;
  }
  return volume;
}

/// Each directed edge once, and its reverse too.
bool is_closed(const Mesh& mesh) {
  std::set<std::pair<int, int>> edges;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (!edges.emplace(mesh.triangles(k, i), mesh.triangles((k + 1) % 3, i)).second) return false;
    }
  }
  for (const auto& [from, to] : edges) {
    if (edges.count({to, from}) == 0) return false;
  }
  return true;
}

}  // namespace

Mesh convex_hull(const Eigen::Matrix3Xd& points) {
  std::vector<Kernel::Point_3> input;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    input.emplace_back(points(0, i), points(1, i), points(2, i));
  }
  Surface surface;
  CGAL::convex_hull_3(input.begin(), input.end(), surface);

  Mesh hull;
  hull.vertices.resize(3, static_cast<Eigen::Index>(surface.number_of_vertices()));
  hull.triangles.resize(3, static_cast<Eigen::Index>(surface.number_of_faces()));
  for (const auto vertex : surface.vertices()) {
    const auto& p = surface.point(vertex);
    hull.vertices.col(static_cast<Eigen::Index>(vertex)) << p.x(), p.y(), p.z();
  }
  for (const auto face : surface.faces()) {
    int k = 0;
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face))) {
      hull.triangles(k++, static_cast<Eigen::Index>(face)) = static_cast<int>(vertex.idx());
    }
  }
  return hull;
}

bool is_convex(const Mesh& mesh, const Mesh& hull) {
  if (!is_closed(mesh)) return false;
  const Eigen::Vector3d p_origin = hull.vertices.rowwise().mean();
  const double volume = std::abs(signed_volume(mesh, p_origin));
  const double filled = signed_volume(hull, p_origin);
  return std::abs(volume - filled) <= kVolumeTolerance * filled;
}

}  // namespace graspless::geometry
