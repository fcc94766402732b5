// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/polygon.hpp"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "graspless/geometry/shape.hpp"

#include "geometry/polygon/cgal_polygon.hpp"
#include "geometry/segment.hpp"

namespace graspless::geometry {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

std::string to_text(const Eigen::Vector2d& p) {
  std::ostringstream out;
  out << "(" << p.x() << ", " << p.y() << ")";
  return out.str();
}

double signed_area(const Eigen::Matrix2Xd& v) {
  double sum = 0;
  for (Eigen::Index i = 0, j = v.cols() - 1; i < v.cols(); j = i++)
    sum += cross(v.col(j), v.col(i));
  return sum / 2;
}

double squared_distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                                   const Eigen::Vector2d& b) {
  return (p - a - nearest_on_segment(p, a, b) * (b - a)).squaredNorm();
}

constexpr double kMinArea = 1e-12;  // [m^2]

void check_vertices(const Eigen::Matrix2Xd& v, const std::string& what) {
  if (v.cols() < 3) {
    throw std::invalid_argument(what + " needs at least 3 vertices, not " +
                                std::to_string(v.cols()));
  }
  for (Eigen::Index i = 0, j = v.cols() - 1; i < v.cols(); j = i++) {
    if (!(v.col(i).cwiseAbs().array() <= kMaxLength).all()) {
      std::ostringstream fault;
      fault << what << " vertex " << i << " must lie within " << kMaxLength
            << " m of the origin along x and y, not at " << to_text(v.col(i));
      throw std::invalid_argument(fault.str());
    }
    if (v.col(i) == v.col(j)) {
      throw std::invalid_argument(what + " repeats vertex " + std::to_string(j) + " at " +
                                  to_text(v.col(i)));
    }
  }
}

}  // namespace

Polygon::Polygon(const Eigen::Matrix2Xd& vertices, const std::string& what) : vertices_(vertices) {
  check_vertices(vertices_, what);
  if (!is_simple(vertices_)) {
    throw std::invalid_argument(what + " crosses or touches itself; it must be a simple polygon");
  }
  const double area = signed_area(vertices_);
  if (std::abs(area) < kMinArea) throw std::invalid_argument(what + " has no area");
  if (area < 0) vertices_ = vertices.rowwise().reverse().eval();
  lower_ = vertices_.rowwise().minCoeff();
  upper_ = vertices_.rowwise().maxCoeff();
}

double Polygon::area() const { return signed_area(vertices_); }

Eigen::Vector2d Polygon::centroid() const {
  // Relative to a vertex, because the plain formula loses digits far from the origin.
  const Eigen::Vector2d o = vertices_.col(0);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double twice_area = 0;
  for (int i = 1; i + 1 < size(); ++i) {
    const Eigen::Vector2d a = vertices_.col(i) - o, b = vertices_.col(i + 1) - o;
    const double c = cross(a, b);
    sum += c * (a + b) / 3;
    twice_area += c;
  }
  return o + sum / twice_area;
}

bool Polygon::is_convex() const {
  const auto corner = [&](int i) { return vertices_.col(i < size() ? i : i - size()); };
  for (int i = 0; i < size(); ++i) {
    if (cross(corner(i + 1) - corner(i), corner(i + 2) - corner(i + 1)) < 0) return false;
  }
  return true;
}

bool Polygon::contains(const Eigen::Vector2d& p) const {
  if ((p.array() < lower_.array()).any() || (p.array() > upper_.array()).any()) return false;
  bool inside = false;  // parity of the crossings of a ray from p towards +x
  for (int i = 0, j = size() - 1; i < size(); j = i++) {
    const double yi = vertices_(1, i), yj = vertices_(1, j);
    if ((yi > p.y()) == (yj > p.y())) continue;
    const double x =
        vertices_(0, i) + (p.y() - yi) / (yj - yi) * (vertices_(0, j) - vertices_(0, i));
    if (p.x() < x) inside = !inside;
  }
  return inside;
}

double Polygon::depth(const Eigen::Vector2d& p) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0, j = size() - 1; i < size(); j = i++) {
    nearest = std::min(nearest, squared_distance_to_segment(p, vertices_.col(j), vertices_.col(i)));
  }
  return contains(p) ? std::sqrt(nearest) : -std::sqrt(nearest);
}

bool Polygon::has_margin(const Eigen::Vector2d& p, double margin) const {
  constexpr double kSurely = 1 + 1e-9;
  if (!contains(p)) return false;
  for (int i = 0, j = size() - 1; i < size(); j = i++) {
    const Eigen::Vector2d a = vertices_.col(j), b = vertices_.col(i), ab = b - a;
    const double area = cross(ab, p - a);  // distance from the line times the length
    if (area * area >= kSurely * margin * margin * ab.squaredNorm()) continue;
    if (std::sqrt(squared_distance_to_segment(p, a, b)) < margin) return false;
  }
  return true;
}

Polygon::Edge Polygon::edge(int index) const {
  if (index < 0 || index >= size()) {
    throw std::invalid_argument("index is " + std::to_string(index) +
                                "; the polygon has edges 0 to " + std::to_string(size() - 1));
  }
  const Eigen::Vector2d a = vertices_.col(index), b = vertices_.col((index + 1) % size());
  const Eigen::Vector2d along = (b - a).normalized();
  return {index, a, b, {-along.y(), along.x()}};
}

Polygon::Edge Polygon::nearest_edge(const Eigen::Vector2d& p) const {
  constexpr double kTie = 1e-9;  // [m]
  const auto distance = [&](const Edge& e) {
    return std::sqrt(squared_distance_to_segment(p, e.a, e.b));
  };
  const auto outside = [&](const Edge& e) { return e.inward.dot(e.a - p); };
  Edge nearest = edge(0);
  for (int i = 1; i < size(); ++i) {
    const Edge other = edge(i);
    const double gain = distance(nearest) - distance(other);
    if (gain > kTie || (gain > -kTie && outside(other) > outside(nearest))) nearest = other;
  }
  return nearest;
}

std::vector<Polygon> Polygon::convex_parts() const {
  if (is_convex()) return {*this};
  std::vector<Polygon> parts;
  for (const Eigen::Matrix2Xd& part : convex_partition(vertices_)) {
    // Vertices almost on a line, as of a cloud on a grid, leave slivers.
    if (std::abs(signed_area(part)) >= kMinArea) parts.emplace_back(part);
  }
  return parts;
}

}  // namespace graspless::geometry
