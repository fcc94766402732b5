// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/point_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/spatial_sort.h>

#include "graspless/geometry/shape.hpp"
#include "graspless/watch.hpp"

namespace graspless::geometry {
namespace {

constexpr double kMaxGridPoints = 1e7;  // an outline in millimetres would fill the memory

std::string number(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Alpha_shape_vertex_base_2<Kernel>;

/// A face that polls where CGAL's loops over all faces look at it.
template <class Base = CGAL::Alpha_shape_face_base_2<Kernel>>
class PollingFace : public Base {
 public:
  template <class Structure>
  struct Rebind_TDS {
    using Other = PollingFace<typename Base::template Rebind_TDS<Structure>::Other>;
  };
  using Base::Base;
  const typename Base::Type_of_alpha& get_alpha() const {
    poll();
    return Base::get_alpha();
  }
  void set_alpha(const typename Base::Type_of_alpha& alpha) {
    poll();
    Base::set_alpha(alpha);
  }
  void set_ranges(int edge, const typename Base::Interval_3& ranges) {
    poll();
    Base::set_ranges(edge, ranges);
  }
};

using Face = PollingFace<>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;
using AlphaShape = CGAL::Alpha_shape_2<Delaunay>;
using Loop = std::vector<Eigen::Vector2d>;

/// Directed boundary edges of the shape, with the interior on the left.
std::multimap<AlphaShape::Vertex_handle, AlphaShape::Vertex_handle> boundary(
    const AlphaShape& shape) {
  std::multimap<AlphaShape::Vertex_handle, AlphaShape::Vertex_handle> next;
  for (auto e = shape.alpha_shape_edges_begin(); e != shape.alpha_shape_edges_end(); ++e) {
    poll();
    auto [face, i] = *e;
    if (shape.classify(*e) != AlphaShape::REGULAR) continue;
    if (shape.classify(face) != AlphaShape::INTERIOR) {
      i = face->neighbor(i)->index(face);
      face = e->first->neighbor(e->second);
    }
    next.emplace(face->vertex(AlphaShape::ccw(i)), face->vertex(AlphaShape::cw(i)));
  }
  return next;
}

std::vector<Loop> loops(const AlphaShape& shape) {
  auto next = boundary(shape);
  std::vector<Loop> all;
  while (!next.empty()) {
    Loop loop;
    for (auto at = next.begin(); at != next.end();) {
      loop.emplace_back(at->first->point().x(), at->first->point().y());
      const auto to = at->second;
      next.erase(at);
      at = next.find(to);
    }
    // The first vertex depends on memory addresses. Starting at the lowest makes it repeatable.
    const auto first = std::min_element(loop.begin(), loop.end(), [](const auto& a, const auto& b) {
      return std::make_pair(a.x(), a.y()) < std::make_pair(b.x(), b.y());
    });
    std::rotate(loop.begin(), first, loop.end());
    all.push_back(std::move(loop));
  }
  return all;
}

double twice_area(const Loop& loop) {
  double sum = 0;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    sum += loop[j].x() * loop[i].y() - loop[j].y() * loop[i].x();
  }
  return sum;
}

/// Drops vertices closer than `tolerance` to the chord between the vertices kept around them.
Eigen::Matrix2Xd simplified(const Loop& loop, double tolerance) {
  Loop kept;
  const std::size_t n = loop.size();
  std::size_t anchor = 0;
  kept.push_back(loop[0]);
  for (std::size_t end = 2; end <= n; ++end) {
    poll();
    const Eigen::Vector2d a = loop[anchor], d = (loop[end % n] - a);
    double worst = 0;
    for (std::size_t i = anchor + 1; i < end; ++i) {
      const Eigen::Vector2d p = loop[i] - a;
      worst = std::max(
          worst, d.norm() > 0 ? std::abs(p.x() * d.y() - p.y() * d.x()) / d.norm() : p.norm());
    }
    if (worst <= tolerance) continue;
    anchor = end - 1;
    kept.push_back(loop[anchor]);
  }
  Eigen::Matrix2Xd out(2, static_cast<Eigen::Index>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) out.col(static_cast<Eigen::Index>(i)) = kept[i];
  return out;
}

double twice_area(const AlphaShape& shape) {
  double sum = 0;
  for (auto f = shape.finite_faces_begin(); f != shape.finite_faces_end(); ++f) {
    if (shape.classify(f) != AlphaShape::INTERIOR) continue;
    sum += 2 * shape.triangle(f).area();
  }
  return sum;
}

/// Polygon of the largest loop after simplification, if it is simple and surrounds the shape. It
/// does not where the shape touches itself at a vertex; the caller retries with a larger alpha.
std::optional<Polygon> outer_polygon(const AlphaShape& shape, double tolerance) {
  const Loop* outer = nullptr;
  const std::vector<Loop> all = loops(shape);
  for (const Loop& loop : all) {
    if (!outer || twice_area(loop) > twice_area(*outer)) outer = &loop;
  }
  if (!outer || twice_area(*outer) < (1 - 1e-9) * twice_area(shape)) return std::nullopt;
  try {
    return Polygon(simplified(*outer, tolerance));
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Median distance of a point to its nearest neighbour [m].
double median_spacing(const AlphaShape& shape) {
  std::map<AlphaShape::Vertex_handle, double> nearest;
  for (auto e = shape.finite_edges_begin(); e != shape.finite_edges_end(); ++e) {
    poll();
    const auto a = e->first->vertex(AlphaShape::ccw(e->second));
    const auto b = e->first->vertex(AlphaShape::cw(e->second));
    const double length = std::sqrt(CGAL::squared_distance(a->point(), b->point()));
    for (const auto& vertex : {a, b}) {
      const auto known = nearest.emplace(vertex, length).first;
      known->second = std::min(known->second, length);
    }
  }
  std::vector<double> lengths;
  for (const auto& [vertex, length] : nearest) lengths.push_back(length);
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

/// Least squared radius of discs that leave one piece with all points in it.
double optimal_alpha(AlphaShape& shape) {
  const auto found = shape.find_optimal_alpha(1);
  if (found == shape.alpha_begin()) return *found;
  // CGAL gives the radius after the optimal one, which may be the vast one of a needle.
  const double alpha = 1.5 * *(found - 1);
  const bool is_enough =
      alpha >= shape.find_alpha_solid() && shape.number_of_solid_components(alpha) == 1;
  return is_enough ? std::min(alpha, *found) : *found;
}

/// Throws if one piece is possible only by bridging a gap of many spacings, as with stray points or
/// several objects.
void require_one_piece(const AlphaShape& shape, double gap, const std::string& what) {
  constexpr double kSpacings = 12;
  const double spacing = median_spacing(shape);
  if (gap <= kSpacings * spacing) return;
  throw std::invalid_argument(what + " are not one piece: a gap of about " +
                              std::to_string(2 * gap) + " m between points " +
                              std::to_string(spacing) +
                              " m apart; remove stray points and other objects");
}

double extent(const Eigen::Matrix2Xd& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
}

/// As CGAL inserts a range of points, but with polls.
Delaunay delaunay(const Eigen::Matrix2Xd& points) {
  std::vector<Kernel::Point_2> cloud;
  for (const auto& p : points.colwise()) cloud.emplace_back(p.x(), p.y());
  CGAL::spatial_sort(cloud.begin(), cloud.end(), Kernel());
  Delaunay triangulation;
  Delaunay::Face_handle hint;
  for (const Kernel::Point_2& point : cloud) {
    poll();
    hint = triangulation.insert(point, hint)->face();
  }
  return triangulation;
}

/// True if CGAL would divide by zero: a triangle has a positive area, which predicates find
/// exactly, but its determinant is 0 in double precision.
bool has_needle(const Delaunay& triangulation) {
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    poll();
    const auto q = f->vertex(1)->point() - f->vertex(0)->point();
    const auto r = f->vertex(2)->point() - f->vertex(0)->point();
    if (q.x() * r.y() == q.y() * r.x()) return true;
  }
  return false;
}

/// Rounds points to multiples of 2^-25 of their extent: determinants of differences are exact.
Eigen::Matrix2Xd rounded(const Eigen::Matrix2Xd& points) {
  const double unit = std::exp2(std::ceil(std::log2(extent(points))) - 25);
  return (points / unit).array().round() * unit;
}

/// Delaunay triangulation of points, or of rounded ones if it has needles.
Delaunay spanning_delaunay(const Eigen::Matrix2Xd& points, const std::string& what) {
  Delaunay triangulation = delaunay(points);
  if (triangulation.dimension() == 2 && extent(points) >= kMinLength) {
    if (has_needle(triangulation)) triangulation = delaunay(rounded(points));
    if (triangulation.dimension() == 2) return triangulation;
  }
  throw std::invalid_argument(what + " must span an area; got " + std::to_string(points.cols()) +
                              " points on a line or fewer than three");
}

}  // namespace

Eigen::Matrix2Xd sample_grid(const Polygon& polygon, double spacing) {
  if (!(spacing > 0)) {
    throw std::invalid_argument("spacing must be positive, not " + std::to_string(spacing));
  }
  const Eigen::Vector2d lower = polygon.vertices().rowwise().minCoeff();
  const Eigen::Vector2d upper = polygon.vertices().rowwise().maxCoeff();
  const double points = ((upper - lower) / spacing).cwiseMax(1).prod();
  if (points > kMaxGridPoints) {
    throw std::invalid_argument("spacing " + number(spacing) + " m gives " + number(points) +
                                " points on " + number((upper - lower).x()) + " x " +
                                number((upper - lower).y()) + " m; at most " +
                                number(kMaxGridPoints) + " are allowed");
  }
  std::vector<Eigen::Vector2d> inside;
  for (double x = lower.x() + spacing / 2; x < upper.x(); x += spacing) {
    for (double y = lower.y() + spacing / 2; y < upper.y(); y += spacing) {
      poll();
      if (polygon.contains({x, y})) inside.emplace_back(x, y);
    }
  }
  if (inside.empty()) inside.push_back(polygon.vertices().col(0));
  return Eigen::Map<Eigen::Matrix2Xd>(inside.data()->data(), 2,
                                      static_cast<Eigen::Index>(inside.size()));
}

Polygon outline(const Eigen::Matrix2Xd& points, const std::string& what) {
  if (!points.allFinite()) throw std::invalid_argument(what + " has a value that is not finite");
  if (points.size() > 0 && points.cwiseAbs().maxCoeff() > kMaxLength) {
    throw std::invalid_argument(what + " must lie within " + number(kMaxLength) +
                                " m of the origin along x and y, not at " +
                                number(points.cwiseAbs().maxCoeff()) + " m");
  }
  Delaunay triangulation = spanning_delaunay(points, what);
  AlphaShape shape(triangulation, 0, AlphaShape::REGULARIZED);
  double alpha = optimal_alpha(shape);
  const double spacing = std::sqrt(alpha);  // radius of the largest empty disc [m]
  require_one_piece(shape, spacing, what);
  for (int attempt = 0; attempt < 60; ++attempt, alpha *= 1.5) {
    shape.set_alpha(alpha);
    if (auto polygon = outer_polygon(shape, spacing / 4)) return *polygon;
  }
  throw std::invalid_argument(what + " have no simple outline");
}

}  // namespace graspless::geometry
