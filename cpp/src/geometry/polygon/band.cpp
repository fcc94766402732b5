// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/band.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <stdexcept>

#include "graspless/geometry/shape.hpp"
#include "graspless/watch.hpp"

#include "geometry/polygon/cgal_polygon.hpp"
#include "text.hpp"

namespace graspless::geometry {
namespace {

using Triangle = Eigen::Matrix<double, 2, 3>;

double uniform(std::mt19937_64& rng) { return std::uniform_real_distribution<double>(0, 1)(rng); }

double triangle_area(const Triangle& t) {
  const Eigen::Vector2d a = t.col(1) - t.col(0), b = t.col(2) - t.col(0);
  return (a.x() * b.y() - a.y() * b.x()) / 2;
}

std::vector<Triangle> triangulate(const Polygon& polygon) {
  std::vector<Triangle> triangles;
  for (const Polygon& part : polygon.convex_parts()) {
    poll();
    const Eigen::Matrix2Xd& v = part.vertices();
    for (int i = 1; i + 1 < part.size(); ++i) {
      triangles.push_back((Triangle() << v.col(0), v.col(i), v.col(i + 1)).finished());
    }
  }
  return triangles;
}

/// True if a grid point that is certainly in the core lies in no piece of it. A mitre at a reflex
/// corner reaches at most kMitre times the width, except at notches sharper than a right angle.
bool misses_interior(const Polygon& polygon, double width, const std::vector<Polygon>& core) {
  constexpr double kMitre = 1.4142135623730951 * (1 + 1e-9);
  const Eigen::Vector2d lower = polygon.vertices().rowwise().minCoeff();
  const Eigen::Vector2d upper = polygon.vertices().rowwise().maxCoeff();
  constexpr int kGrid = 24;
  for (int i = 1; i < kGrid; ++i) {
    for (int j = 1; j < kGrid; ++j) {
      poll();
      const Eigen::Vector2d p = lower + (upper - lower).cwiseProduct(Eigen::Vector2d(i, j)) / kGrid;
      if (polygon.depth(p) <= kMitre * width) continue;
      if (std::none_of(core.begin(), core.end(), [&](const Polygon& c) { return c.contains(p); })) {
        return true;
      }
    }
  }
  return false;
}

/// Pieces of the contracted polygon, if each is simple and its vertices lie `width` inside.
std::optional<std::vector<Polygon>> verified_core(const Polygon& polygon, double width) {
  const double slack = 1e-6 * (1 + width);
  std::vector<Polygon> core;
  double area = 0;
  try {
    for (const Eigen::Matrix2Xd& piece : contract(polygon.vertices(), width)) {
      for (const auto& v : piece.colwise()) {
        poll();
        if (polygon.depth(v) < width - slack) return std::nullopt;
      }
      core.emplace_back(piece);
      area += core.back().area();
    }
  } catch (const std::exception&) {  // failed check of CGAL, or a piece that is not simple
    return std::nullopt;
  }
  if (area >= polygon.area() || misses_interior(polygon, width, core)) return std::nullopt;
  return core;
}

}  // namespace

Band::Band(const Polygon& polygon, double width) : polygon_(polygon), width_(width) {
  require_within("band width", width, kMinLength, kMaxLength, " m");
  auto core = verified_core(polygon, width);
  exact_ = core.has_value();
  if (exact_) core_ = std::move(*core);
  triangles_ = triangulate(polygon);
  double sum = 0;
  for (const Triangle& t : triangles_) cumulative_area_.push_back(sum += triangle_area(t));
  for (int i = 0; i < polygon.size(); ++i) {
    const auto e = polygon.edge(i);
    cumulative_length_.push_back((e.b - e.a).norm() + (i ? cumulative_length_.back() : 0));
  }
}

bool Band::contains(const Eigen::Vector2d& p) const {
  if (!polygon_.contains(p)) return false;
  if (!exact_) return polygon_.depth(p) <= width_;
  return std::none_of(core_.begin(), core_.end(), [&](const Polygon& c) { return c.contains(p); });
}

std::optional<Eigen::Vector2d> Band::sample(std::mt19937_64& rng, double margin) const {
  constexpr int kAttempts = 1000;
  for (int i = 0; i < kAttempts; ++i) {
    poll();
    const Eigen::Vector2d p = exact_ ? draw_inside(rng) : draw_near_edge(rng);
    if (contains(p) && (margin <= 0 || polygon_.depth(p) >= margin)) return p;
  }
  return std::nullopt;
}

Eigen::Vector2d Band::draw_inside(std::mt19937_64& rng) const {
  const double area = uniform(rng) * cumulative_area_.back();
  const auto found = std::upper_bound(cumulative_area_.begin(), cumulative_area_.end() - 1, area);
  const Triangle& t = triangles_[found - cumulative_area_.begin()];
  double a = uniform(rng), b = uniform(rng);
  if (a + b > 1) {
    a = 1 - a;
    b = 1 - b;
  }
  return t.col(0) + a * (t.col(1) - t.col(0)) + b * (t.col(2) - t.col(0));
}

Eigen::Vector2d Band::draw_near_edge(std::mt19937_64& rng) const {
  const double length = uniform(rng) * cumulative_length_.back();
  const auto found =
      std::upper_bound(cumulative_length_.begin(), cumulative_length_.end() - 1, length);
  const auto e = polygon_.edge(static_cast<int>(found - cumulative_length_.begin()));
  return e.a + uniform(rng) * (e.b - e.a) + uniform(rng) * width_ * e.inward;
}

}  // namespace graspless::geometry
