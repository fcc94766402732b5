// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/task/rim.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/convex_hull.hpp"
#include "slide/placement.hpp"

namespace graspless::slide {

using Eigen::Vector2d;

namespace {

constexpr double kSpacing = 0.002;  // of points on a rim [m]
constexpr int kChords = 36;

/// Distance from a point within a convex polygon to its boundary along a unit vector [m].
double distance_along(const Eigen::Matrix2Xd& corners, const Vector2d& from, const Vector2d& u) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < corners.cols(); ++i) {
    const Vector2d side = corners.col((i + 1) % corners.cols()) - corners.col(i);
    const Vector2d outward(side.y(), -side.x());
    const double rate = outward.dot(u);
    if (rate > 0) nearest = std::min(nearest, outward.dot(corners.col(i) - from) / rate);
  }
  return std::max(nearest, 0.0);
}

}  // namespace

double rim_distance(const geometry::Polygon& outline, const Vector2d& center) {
  const Eigen::Matrix2Xd hull = geometry::convex_outline(outline.vertices());
  double largest = 0;
  for (int k = 0; k < kChords; ++k) {
    const double angle = k * M_PI / kChords;
    const Vector2d u(std::cos(angle), std::sin(angle));
    const double a = distance_along(hull, center, u), b = distance_along(hull, center, -u);
    if (a + b > 0) largest = std::max(largest, 2 * a * b / (a + b));  // each bears by its lever
  }
  return largest;
}

bool is_held_by_rim(const Problem& problem, const Planar& object_S, double margin) {
  const geometry::Polygon &rim = problem.object.outline(), &Q = problem.support.polygon();
  std::vector<Vector2d> held;
  for (int i = 0; i < rim.size(); ++i) {
    const geometry::Polygon::Edge edge = rim.edge(i);
    const int count = std::max(1, static_cast<int>(std::ceil((edge.b - edge.a).norm() / kSpacing)));
    for (int k = 0; k < count; ++k) {
      const Vector2d p = object_S * Vector2d(edge.a + (edge.b - edge.a) * k / count);
      if (Q.contains(p)) held.push_back(p);
    }
  }
  if (held.size() < 3) return false;
  const Eigen::Matrix2Xd hull = geometry::convex_outline(Eigen::Map<const Eigen::Matrix2Xd>(
      held.front().data(), 2, static_cast<Eigen::Index>(held.size())));
  const Vector2d com = com_foot(problem, object_S);
  for (Eigen::Index i = 0; i < hull.cols(); ++i) {
    const Vector2d a = hull.col(i), side = hull.col((i + 1) % hull.cols()) - a;
    if (Vector2d(-side.y(), side.x()).dot(com - a) < margin * side.norm()) return false;
  }
  return hull.cols() >= 3;
}

}  // namespace graspless::slide
