// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/polygon.hpp"

#include <cmath>
#include <random>

#include "graspless/geometry/band.hpp"
#include "graspless/geometry/point_cloud.hpp"

#include "fuzz/targets.hpp"

namespace graspless::fuzz {
namespace {

using namespace geometry;

Eigen::Matrix2Xd points(Bytes& bytes, int count) {
  Eigen::Matrix2Xd points(2, count);
  for (double& value : points.reshaped()) value = bytes.number(-1, 1);
  return points;
}

/// Corners around the origin, so that most outlines are simple, or anywhere.
Eigen::Matrix2Xd corners(Bytes& bytes) {
  const bool anywhere = bytes.chance(4);
  Eigen::Matrix2Xd corners = points(bytes, bytes.whole(0, 24));
  if (anywhere) return corners;
  for (Eigen::Index i = 0; i < corners.cols(); ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(corners.cols());
    const double radius = 1.1 + corners(0, i);
    corners.col(i) = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return corners;
}

void require_parts(const Polygon& polygon) {
  double area = 0;
  for (const Polygon& part : polygon.convex_parts()) {
    require(part.is_convex(), "convex parts are convex");
    area += part.area();
  }
  require(std::abs(area - polygon.area()) <= 1e-9 * polygon.area(), "parts cover the polygon");
}

void require_band(const Polygon& polygon, double width) {
  const Band band(polygon, width);
  for (const Polygon& piece : band.core()) {
    require(piece.area() <= polygon.area(), "a piece of the core is smaller than the polygon");
  }
  std::mt19937_64 rng(1);
  for (int i = 0; i < 4; ++i) {
    const auto p = band.sample(rng);
    if (!p) return;
    require(polygon.depth(*p) >= -1e-9, "samples of a band lie in the polygon");
    require(!band.exact() || band.contains(*p), "samples of a band lie in it");
  }
}

void require_outline(const Eigen::Matrix2Xd& cloud) {
  const Polygon hull = outline(cloud);
  const double size = cloud.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < cloud.cols(); ++i) {
    require(hull.depth(cloud.col(i)) >= -size, "an outline surrounds the points");
  }
}

}  // namespace

void use_polygon(Bytes bytes) {
  if (bytes.chance(4)) {
    accepts([&] { require_outline(points(bytes, bytes.whole(0, 40))); });
    return;
  }
  accepts([&] {
    const Polygon polygon(corners(bytes));
    require(polygon.area() > 0, "the area of a polygon is positive");
    require(polygon.centroid().allFinite(), "a centroid is finite");
    require_parts(polygon);
    require_band(polygon, bytes.number(0, 0.5));
    sample_grid(polygon, bytes.number(0.05, 1));
    const Eigen::Vector2d p = points(bytes, 1);
    if (!p.allFinite()) return;
    require(polygon.nearest_edge(p).index < polygon.size(), "the nearest edge exists");
    if (std::abs(polygon.depth(p)) > 1e-9) {
      require(polygon.contains(p) == (polygon.depth(p) > 0), "the inside has positive depth");
    }
  });
}

}  // namespace graspless::fuzz
