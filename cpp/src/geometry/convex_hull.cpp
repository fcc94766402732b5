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
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>
#include <Eigen/Eigenvalues>

#include "graspless/watch.hpp"

namespace graspless::geometry {
namespace {

// A hull thinner than this fraction of its width spans no volume that a collision checker can use.
constexpr double kMinThinness = 1e-9;

// Exact predicates give the correct hull of coplanar and nearly coplanar points. No point is
// constructed, so inexact constructions suffice.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;
using Edge = Surface::Halfedge_index;
using Face = Surface::Face_index;
using Side = std::vector<Kernel::Point_3>;  // corners counter-clockwise seen from outside

// Clouds of this size and more are polled for, at the cost of CGAL's fastest predicate.
constexpr std::size_t kMany = 2000;

/// CGAL takes quadratic time where many points lie in one plane.
struct PollingTraits : CGAL::Convex_hull_traits_3<Kernel, Surface, CGAL::Tag_true> {
  struct Has_on_positive_side_3 : Convex_hull_traits_3::Has_on_positive_side_3 {
    bool operator()(const Plane_3& plane, const Point_3& point) const {
      poll();
      return Convex_hull_traits_3::Has_on_positive_side_3::operator()(plane, point);
    }
  };
  Has_on_positive_side_3 has_on_positive_side_3_object() const { return {}; }
};

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

  std::vector<Side> polygons() const {
    std::vector<Side> polygons(num_sides_);
    for (const Edge edge : surface_.halfedges()) {
      poll();
      if (side(edge) == kOutside) continue;
      Side& polygon = polygons[side(edge)];
      if (!is_rim(edge) || !polygon.empty()) continue;
      Edge at = edge;
      do {
        const Vertex corner = surface_.target(at);
        if (is_corner(corner)) polygon.push_back(surface_.point(corner));
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
Mesh canonical(const std::vector<Side>& sides) {
  std::map<Kernel::Point_3, int> number;
  for (const Side& side : sides) {
    poll();
    for (const Kernel::Point_3& corner : side) number[corner] = 0;
  }
  Mesh hull;
  hull.vertices.resize(3, static_cast<Eigen::Index>(number.size()));
  int next = 0;
  for (auto& [point, at] : number) {
    hull.vertices.col(next) << point.x(), point.y(), point.z();
    at = next++;
  }
  std::vector<std::array<int, 3>> triangles;
  for (const Side& side : sides) {
    std::vector<int> corners;
    for (const Kernel::Point_3& corner : side) corners.push_back(number.at(corner));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    for (std::size_t i = 2; i < corners.size(); ++i) {
      triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  std::sort(triangles.begin(), triangles.end());
  hull.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    hull.triangles.col(i) = Eigen::Map<const Eigen::Vector3i>(triangles[i].data());
  }
  return hull;
}

/// Corners of the hull of the points at this height, counter-clockwise seen from above.
std::vector<Kernel::Point_2> hull_at(const Eigen::Matrix3Xd& points, double height) {
  std::vector<Kernel::Point_2> level, corners;
  for (const auto& p : points.colwise()) {
    if (p.z() == height) level.emplace_back(p.x(), p.y());
  }
  CGAL::convex_hull_2(level.begin(), level.end(), std::back_inserter(corners));
  return corners;
}

/// Sides of the hull of points at two heights with the same outline; of other points, nothing.
std::vector<Side> prism_sides(const Eigen::Matrix3Xd& points) {
  const double bottom = points.row(2).minCoeff(), top = points.row(2).maxCoeff();
  const auto heights = points.row(2).array();
  if (bottom == top || !(heights == bottom || heights == top).all()) return {};
  const std::vector<Kernel::Point_2> outline = hull_at(points, top);
  if (outline.size() < 3 || outline != hull_at(points, bottom)) return {};
  std::vector<Side> sides(2);  // bottom and top
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Kernel::Point_2 &p = outline[i], &q = outline[(i + 1) % outline.size()];
    sides[0].emplace_back(p.x(), p.y(), bottom);
    sides[1].emplace_back(p.x(), p.y(), top);
    sides.push_back(
        {{p.x(), p.y(), bottom}, {q.x(), q.y(), bottom}, {q.x(), q.y(), top}, {p.x(), p.y(), top}});
  }
  std::reverse(sides[0].begin(), sides[0].end());
  return sides;
}

}  // namespace

bool spans_volume(const Eigen::Matrix3Xd& points) {
  if (points.cols() < 4) return false;
  const Eigen::Matrix3Xd centred = points.colwise() - points.rowwise().mean().eval();
  const double width = centred.cwiseAbs().maxCoeff();
  if (!(width > 0)) return false;
  // Normalised by size, so that squares of tiny lengths do not underflow.
  const Eigen::Matrix3d moments = (centred / width) * (centred / width).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments);
  const Eigen::VectorXd along = (axes.eigenvectors().col(0).transpose() * centred).transpose();
  return along.maxCoeff() - along.minCoeff() > kMinThinness * width;
}

Mesh convex_hull(const Eigen::Matrix3Xd& points) {
  if (const std::vector<Side> sides = prism_sides(points); !sides.empty()) return canonical(sides);
  std::vector<Kernel::Point_3> input;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    input.emplace_back(points(0, i), points(1, i), points(2, i));
  }
  Surface surface;
  if (input.size() < kMany) {
    CGAL::convex_hull_3(input.begin(), input.end(), surface);
  } else {
    CGAL::convex_hull_3(input.begin(), input.end(), surface, PollingTraits());
  }
  return canonical(HullSides(surface).polygons());
}

Eigen::Matrix4Xd half_spaces(const Mesh& hull) {
  Eigen::Matrix4Xd planes(4, hull.triangles.cols());
  const Eigen::Vector3d middle = hull.vertices.rowwise().mean();
  Eigen::Index count = 0;
  for (const auto& corners : hull.triangles.colwise()) {
    const Eigen::Vector3d a = hull.vertices.col(corners[0]), b = hull.vertices.col(corners[1]),
                          c = hull.vertices.col(corners[2]);
    Eigen::Vector3d normal = (b - a).cross(c - a);
    if (!(normal.norm() > 0)) continue;
    normal.normalize();
    if (normal.dot(middle - a) > 0) normal = -normal;
    planes.col(count++) << normal, normal.dot(a);
  }
  return planes.leftCols(count);
}

Eigen::Matrix2Xd convex_outline(const Eigen::Matrix2Xd& points) {
  std::vector<Kernel::Point_2> input, corners;
  for (const auto& p : points.colwise()) input.emplace_back(p.x(), p.y());
  CGAL::convex_hull_2(input.begin(), input.end(), std::back_inserter(corners));
  Eigen::Matrix2Xd hull(2, static_cast<Eigen::Index>(corners.size()));
  for (Eigen::Index i = 0; i < hull.cols(); ++i) {
    const Kernel::Point_2& p = corners[i];
    hull.col(i) << p.x(), p.y();
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
