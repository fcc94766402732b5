// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/convex_hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

namespace graspless::geometry {
namespace {

// Exact predicates give the correct hull of coplanar and nearly coplanar points. No point is
// constructed, so inexact constructions suffice.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;
using Edge = Surface::Halfedge_index;
using Face = Surface::Face_index;

// Relative difference of two volumes that counts as rounding.
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

/// True if each directed edge occurs once, and so does its reverse.
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

/// Planar sides of a hull. CGAL's triangulation of a side and its order depend on memory addresses.
/// The sides themselves do not.
class HullSides {
 public:
  explicit HullSides(const Surface& surface)
      : surface_(surface), side_(surface.number_of_faces(), -1) {
    for (const Face face : surface.faces()) {
      if (side_[face] < 0) flood(face, num_sides_++);
    }
  }

  /// Corners of every side in order, counter-clockwise seen from outside.
  std::vector<std::vector<Vertex>> polygons() const {
    std::vector<std::vector<Vertex>> polygons(static_cast<std::size_t>(num_sides_));
    for (const Edge edge : surface_.halfedges()) {
      if (side(edge) == kOutside) continue;
      std::vector<Vertex>& polygon = polygons[static_cast<std::size_t>(side(edge))];
      if (!is_rim(edge) || !polygon.empty()) continue;
      Edge at = edge;
      do {
        if (is_corner(surface_.target(at))) polygon.push_back(surface_.target(at));
        at = next_on_rim(at);
      } while (at != edge);
    }
    return polygons;
  }

 private:
  static constexpr int kOutside = -1;  // beyond the border of a flat hull
  int side(Edge edge) const {
    return surface_.is_border(edge) ? kOutside : side_[surface_.face(edge)];
  }
  bool is_rim(Edge edge) const { return side(edge) != side(surface_.opposite(edge)); }

  Edge next_on_rim(Edge edge) const {
    edge = surface_.next(edge);
    while (!is_rim(edge)) edge = surface_.next(surface_.opposite(edge));
    return edge;
  }

  /// False for a vertex in the interior of a side or of an edge of the hull.
  bool is_corner(Vertex vertex) const {
    std::set<int> sides;
    for (const Edge edge : surface_.halfedges_around_target(surface_.halfedge(vertex))) {
      sides.insert(side(edge));
    }
    return sides.size() > 2 || sides.count(kOutside) > 0;
  }

  bool is_flat(Edge edge) const {
    const auto point = [&](Edge e) { return surface_.point(surface_.target(e)); };
    const Edge back = surface_.opposite(edge);
    return CGAL::coplanar(point(edge), point(back), point(surface_.next(edge)),
                          point(surface_.next(back)));
  }

  void flood(Face first, int side) {
    side_[first] = side;
    for (std::vector<Face> open{first}; !open.empty();) {
      const Face face = open.back();
      open.pop_back();
      for (const Edge edge : surface_.halfedges_around_face(surface_.halfedge(face))) {
        if (surface_.is_border(surface_.opposite(edge))) continue;
        const Face beyond = surface_.face(surface_.opposite(edge));
        if (side_[beyond] >= 0 || !is_flat(edge)) continue;
        side_[beyond] = side;
        open.push_back(beyond);
      }
    }
  }

  const Surface& surface_;
  std::vector<int> side_;  // of a face
  int num_sides_ = 0;
};

/// The hull with sorted corners and triangles. Each side is a fan from its first corner.
Mesh canonical(const Surface& surface) {
  const std::vector<std::vector<Vertex>> polygons = HullSides(surface).polygons();
  std::map<Kernel::Point_3, int> number;
  for (const auto& polygon : polygons) {
    for (const Vertex vertex : polygon) number[surface.point(vertex)] = 0;
  }
  Mesh hull;
  hull.vertices.resize(3, static_cast<Eigen::Index>(number.size()));
  int next = 0;
  for (auto& [point, at] : number) {
    hull.vertices.col(next) << point.x(), point.y(), point.z();
    at = next++;
  }
  std::vector<std::array<int, 3>> triangles;
  for (const auto& polygon : polygons) {
    std::vector<int> corners;
    for (const Vertex vertex : polygon) corners.push_back(number.at(surface.point(vertex)));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    for (std::size_t i = 2; i < corners.size(); ++i) {
      triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  std::sort(triangles.begin(), triangles.end());
  hull.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    hull.triangles.col(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::Vector3i>(triangles[i].data());
  }
  return hull;
}

}  // namespace

Mesh convex_hull(const Eigen::Matrix3Xd& points) {
  std::vector<Kernel::Point_3> input;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    input.emplace_back(points(0, i), points(1, i), points(2, i));
  }
  Surface surface;
  CGAL::convex_hull_3(input.begin(), input.end(), surface);
  return canonical(surface);
}

bool is_convex(const Mesh& mesh, const Mesh& hull) {
  if (!is_closed(mesh)) return false;
  const Eigen::Vector3d p_origin = hull.vertices.rowwise().mean();
  const double volume = std::abs(signed_volume(mesh, p_origin));
  const double filled = signed_volume(hull, p_origin);
  return std::abs(volume - filled) <= kVolumeTolerance * filled;
}

}  // namespace graspless::geometry
