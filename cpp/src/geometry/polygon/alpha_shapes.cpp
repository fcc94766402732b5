// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/alpha_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <CGAL/spatial_sort.h>

#include "graspless/watch.hpp"

#include "geometry/disjoint_sets.hpp"
#include "geometry/quantile.hpp"

namespace graspless::geometry::alpha {

double extent(const Eigen::Matrix2Xd& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
}

AlphaShapes::AlphaShapes(const Eigen::Matrix2Xd& points) {
  insert(points);
  if (!read_faces()) {
    delaunay_.clear();
    insert(rounded(points));
    read_faces();
  }
  int count = 0;
  for (const auto vertex : delaunay_.finite_vertex_handles()) vertex->info() = count++;
  std::sort(faces_.begin(), faces_.end(), [](const auto& a, const auto& b) {
    poll();
    return std::make_pair(a->info().squared_radius, a->info().index) <
           std::make_pair(b->info().squared_radius, b->info().index);
  });
}

double AlphaShapes::optimal_alpha() const {
  constexpr double kMore = 1.5;
  const std::vector<double> spectrum = alpha_spectrum();
  const std::vector<int> pieces = count_pieces(spectrum);
  const auto start = std::lower_bound(spectrum.begin(), spectrum.end(), least_covering());
  const auto is_split = [](int count) { return count > 1; };
  const auto best =
      static_cast<std::size_t>(std::partition_point(pieces.begin() + (start - spectrum.begin()),
                                                    pieces.end() - 1, is_split) -
                               pieces.begin());
  if (best + 1 == spectrum.size()) return spectrum[best];
  const double more = kMore * spectrum[best];
  const auto at = std::upper_bound(spectrum.begin(), spectrum.end(), more) - spectrum.begin() - 1;
  if (more > spectrum[best + 1] || is_split(pieces[at])) {
    return spectrum[best + 1];
  }
  return more;
}

double AlphaShapes::median_spacing() const {
  std::vector<double> nearest(delaunay_.number_of_vertices(),
                              std::numeric_limits<double>::infinity());
  for (const auto& [face, i] : delaunay_.finite_edges()) {
    poll();
    const auto a = face->vertex(Delaunay::ccw(i)), b = face->vertex(Delaunay::cw(i));
    const double length = std::sqrt(CGAL::squared_distance(a->point(), b->point()));
    for (const int vertex : {a->info(), b->info()}) {
      auto& least = nearest[vertex];
      least = std::min(least, length);
    }
  }
  return median(nearest);
}

// The shortest steps that join all points are edges of the Delaunay triangulation.
int AlphaShapes::count_strays(double longest) const {
  const int count = num_points();
  DisjointSets groups(count);
  for (const auto& [face, i] : delaunay_.finite_edges()) {
    poll();
    const auto a = face->vertex(Delaunay::ccw(i)), b = face->vertex(Delaunay::cw(i));
    if (CGAL::squared_distance(a->point(), b->point()) <= longest * longest)
      groups.join(a->info(), b->info());
  }
  int largest = 0;
  for (int i = 0; i < count; ++i) largest = std::max(largest, groups.size(i));
  return count - largest;
}

std::vector<Loop> AlphaShapes::loops(double alpha) const {
  const std::vector<Edge> edges = boundary(alpha);
  std::vector<bool> used(edges.size(), false);
  std::vector<Loop> all;
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (used[start]) continue;
    Loop loop;
    for (std::size_t at = start; !used[at]; at = following(edges, at)) {
      poll();
      used[at] = true;
      loop.points.push_back(position(edges[at].from));
      loop.touches |= meets(edges, at);
    }
    auto& points = loop.points;
    std::rotate(points.begin(), std::min_element(points.begin(), points.end(), is_left_of),
                points.end());
    all.push_back(std::move(loop));
  }
  return all;
}

bool AlphaShapes::is_left_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::make_pair(a.x(), a.y()) < std::make_pair(b.x(), b.y());
}

Eigen::Vector2d AlphaShapes::position(VertexHandle vertex) {
  return {vertex->point().x(), vertex->point().y()};
}

Eigen::Matrix2Xd AlphaShapes::rounded(const Eigen::Matrix2Xd& points) {
  const double unit = std::exp2(std::ceil(std::log2(extent(points))) - 25);
  return (points / unit).array().round() * unit;
}

bool AlphaShapes::read_faces() {
  faces_.clear();
  const auto radius = Kernel().compute_squared_radius_2_object();
  for (const auto face : delaunay_.finite_face_handles()) {
    poll();
    const auto q = corner(face, 1) - corner(face, 0), r = corner(face, 2) - corner(face, 0);
    if (q.x() * r.y() == q.y() * r.x()) return false;  // CGAL would divide by the difference
    const double squared = radius(corner(face, 0), corner(face, 1), corner(face, 2));
    if (!std::isfinite(squared)) return false;
    face->info() = {squared, static_cast<int>(faces_.size())};
    faces_.push_back(face);
  }
  return true;
}

void AlphaShapes::insert(const Eigen::Matrix2Xd& points) {
  std::vector<Kernel::Point_2> cloud;
  for (const auto& p : points.colwise()) cloud.emplace_back(p.x(), p.y());
  CGAL::spatial_sort(cloud.begin(), cloud.end(), Kernel());
  FaceHandle hint;
  for (const Kernel::Point_2& point : cloud) {
    poll();
    hint = delaunay_.insert(point, hint)->face();
  }
}

std::vector<double> AlphaShapes::alpha_spectrum() const {
  std::vector<double> values;
  for (const FaceHandle face : faces_) values.push_back(face->info().squared_radius);
  const auto side = Kernel().side_of_bounded_circle_2_object();
  const auto radius = Kernel().compute_squared_radius_2_object();
  for (const auto& [face, i] : delaunay_.finite_edges()) {
    poll();
    const auto &p = corner(face, Delaunay::ccw(i)), &q = corner(face, Delaunay::cw(i));
    const FaceHandle other = face->neighbor(i);
    const auto holds = [&](FaceHandle at, int opposite) {
      return !delaunay_.is_infinite(at) &&
             side(p, q, corner(at, opposite)) == CGAL::ON_BOUNDED_SIDE;
    };
    if (!holds(face, i) && !holds(other, other->index(face))) values.push_back(radius(q, p));
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  values.erase(values.begin(), std::upper_bound(values.begin(), values.end(), 0.0));
  return values;
}

double AlphaShapes::least_covering() const {
  std::vector<bool> covered(delaunay_.number_of_vertices(), false);
  double last = 0;
  for (const FaceHandle face : faces_) {
    for (int i = 0; i < 3; ++i) {
      const auto vertex = static_cast<std::size_t>(face->vertex(i)->info());
      if (!covered[vertex]) last = face->info().squared_radius;
      covered[vertex] = true;
    }
  }
  return last;
}

std::vector<int> AlphaShapes::count_pieces(const std::vector<double>& values) const {
  DisjointSets joined(static_cast<int>(faces_.size()));
  std::vector<bool> is_in(faces_.size(), false);  // the shape
  std::vector<int> pieces;
  int count = 0;
  auto next = faces_.begin();
  for (const double value : values) {
    for (; next != faces_.end() && (*next)->info().squared_radius <= value; ++next) {
      poll();
      const int own = (*next)->info().index;
      is_in[own] = true;
      ++count;
      for (int i = 0; i < 3; ++i) {
        const int other = (*next)->neighbor(i)->info().index;
        if (other >= 0 && is_in[other] && joined.join(own, other)) --count;
      }
    }
    pieces.push_back(count);
  }
  return pieces;
}

std::vector<AlphaShapes::Edge> AlphaShapes::boundary(double alpha) const {
  std::vector<Edge> edges;
  for (auto [face, i] : delaunay_.finite_edges()) {
    poll();
    const FaceHandle other = face->neighbor(i);
    const bool inside = face->info().squared_radius <= alpha;
    if (inside == (other->info().squared_radius <= alpha)) continue;
    if (!inside) {
      i = other->index(face);
      face = other;
    }
    edges.push_back({face->vertex(Delaunay::ccw(i)), face->vertex(Delaunay::cw(i))});
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::make_pair(a.from->info(), a.to->info()) <
           std::make_pair(b.from->info(), b.to->info());
  });
  return edges;
}

bool AlphaShapes::meets(const std::vector<Edge>& edges, std::size_t at) {
  const auto leaves = [&](std::size_t other) { return edges[other].from == edges[at].from; };
  return (at > 0 && leaves(at - 1)) || (at + 1 < edges.size() && leaves(at + 1));
}

std::size_t AlphaShapes::following(const std::vector<Edge>& edges, std::size_t at) {
  const Edge& edge = edges[at];
  auto next = std::partition_point(edges.begin(), edges.end(), [&](const Edge& other) {
    return other.from->info() < edge.to->info();
  });
  const Eigen::Vector2d p = position(edge.to), back = position(edge.from) - p;
  double least = std::numeric_limits<double>::infinity();
  auto best = next;
  for (; next != edges.end() && next->from == edge.to; ++next) {
    const Eigen::Vector2d out = position(next->to) - p;
    const double angle = std::atan2(back.x() * out.y() - back.y() * out.x(), back.dot(out));
    const double turn = angle > 0 ? angle : angle + 2 * M_PI;
    if (turn < least) best = next;
    least = std::min(least, turn);
  }
  return static_cast<std::size_t>(best - edges.begin());
}

}  // namespace graspless::geometry::alpha
