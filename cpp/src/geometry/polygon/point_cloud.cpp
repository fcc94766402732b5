// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/point_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "graspless/geometry/shape.hpp"
#include "graspless/watch.hpp"

#include "geometry/polygon/alpha_shapes.hpp"
#include "text.hpp"

namespace graspless::geometry {
namespace {

using alpha::AlphaShapes, alpha::extent, alpha::Loop;
using Points = std::vector<Eigen::Vector2d>;

constexpr double kMaxGridPoints = 1e7;  // an outline in millimetres would fill the memory

double twice_area(const Points& loop) {
  double sum = 0;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    sum += loop[j].x() * loop[i].y() - loop[j].y() * loop[i].x();
  }
  return sum;
}

/// Drops vertices closer than `tolerance` to the chord between the vertices kept around them.
Eigen::Matrix2Xd simplified(const Points& loop, double tolerance) {
  Points kept;
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
  for (std::size_t i = 0; i < kept.size(); ++i) out.col(i) = kept[i];
  return out;
}

/// Polygon of the largest loop after simplification, if it is simple.
std::optional<Polygon> outer_polygon(const AlphaShapes& shapes, double alpha, double tolerance) {
  const Loop* outer = nullptr;
  const std::vector<Loop> all = shapes.loops(alpha);
  for (const Loop& loop : all) {
    if (!outer || twice_area(loop.points) > twice_area(outer->points)) outer = &loop;
  }
  if (!outer || outer->points.size() < 3 || outer->touches) return std::nullopt;
  try {
    return Polygon(simplified(outer->points, tolerance));
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // not simple after simplification
  }
}

/// Throws if one piece is possible only by bridging a gap of many spacings, as with stray points or
/// several objects. A few points count as stray at a smaller gap: points that are spread at random
/// have gaps of four.
void require_one_piece(const AlphaShapes& shapes, double gap, const std::string& what) {
  constexpr double kSpacings = 12, kOfStray = 6;
  constexpr double kFew = 0.02;  // of all points
  const double spacing = shapes.median_spacing();
  const int strays = shapes.count_strays(kOfStray * spacing);
  if (strays > 0 && strays <= kFew * shapes.num_points()) {
    throw std::invalid_argument(what + " have " + std::to_string(strays) +
                                (strays == 1 ? " stray point" : " stray points") + ", more than " +
                                figure(kOfStray * spacing) + " m from the other ones, which are " +
                                figure(spacing) + " m apart; remove them");
  }
  if (gap <= kSpacings * spacing) return;
  throw std::invalid_argument(what + " are not one piece: a gap of about " + figure(2 * gap) +
                              " m between points " + figure(spacing) +
                              " m apart; remove stray points and other objects");
}

}  // namespace

Eigen::Matrix2Xd sample_grid(const Polygon& polygon, double spacing) {
  require(spacing > 0, "spacing", spacing, "must be positive");
  const Eigen::Vector2d lower = polygon.vertices().rowwise().minCoeff();
  const Eigen::Vector2d upper = polygon.vertices().rowwise().maxCoeff();
  const double points = ((upper - lower) / spacing).cwiseMax(1).prod();
  if (points > kMaxGridPoints) {
    throw std::invalid_argument("spacing " + figure(spacing) + " m gives " + figure(points) +
                                " points on " + figure((upper - lower).x()) + " x " +
                                figure((upper - lower).y()) + " m; at most " +
                                figure(kMaxGridPoints) + " are allowed");
  }
  // Room for all points of the grid: memory that is not used is not resident.
  Eigen::Matrix2Xd inside(2, static_cast<Eigen::Index>(points) + 1);
  Eigen::Index count = 0;
  for (double x = lower.x() + spacing / 2; x < upper.x(); x += spacing) {
    for (double y = lower.y() + spacing / 2; y < upper.y(); y += spacing) {
      poll();
      if (!polygon.contains({x, y})) continue;
      if (count == inside.cols()) inside.conservativeResize(2, 2 * count);
      inside.col(count++) << x, y;
    }
  }
  if (count == 0) inside.col(count++) = polygon.vertices().col(0);
  inside.conservativeResize(2, count);
  return inside;
}

Polygon outline(const Eigen::Matrix2Xd& points, const std::string& what) {
  if (!points.allFinite()) throw std::invalid_argument(what + " has a value that is not finite");
  if (points.size() > 0 && points.cwiseAbs().maxCoeff() > kMaxLength) {
    throw std::invalid_argument(what + " must lie within " + figure(kMaxLength) +
                                " m of the origin along x and y, not at " +
                                figure(points.cwiseAbs().maxCoeff()) + " m");
  }
  const AlphaShapes shapes(points);
  if (!shapes.span_an_area() || extent(points) < kMinLength) {
    throw std::invalid_argument(what + " must span an area; got " + std::to_string(points.cols()) +
                                " points on a line or fewer than three");
  }
  double alpha = shapes.optimal_alpha();
  const double spacing = std::sqrt(alpha);  // radius of the largest empty disc [m]
  require_one_piece(shapes, spacing, what);
  for (int attempt = 0; attempt < 60; ++attempt, alpha *= 1.5) {
    if (auto polygon = outer_polygon(shapes, alpha, spacing / 4)) return *polygon;
  }
  throw std::invalid_argument(what + " have no simple outline");
}

}  // namespace graspless::geometry
