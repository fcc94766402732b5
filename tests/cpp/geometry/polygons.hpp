// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <initializer_list>
#include <random>
#include <vector>

#include "graspless/geometry/polygon.hpp"

namespace graspless::geometry {

inline Eigen::Matrix2Xd columns(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Matrix2Xd v(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) v.col(i) = points[i];
  return v;
}

inline Polygon square(double side) {
  const double h = side / 2;
  return Polygon(columns({{-h, -h}, {h, -h}, {h, h}, {-h, h}}));
}

inline Polygon l_shape() {
  return Polygon(columns({{0, 0}, {0.8, 0}, {0.8, 0.3}, {0.3, 0.3}, {0.3, 0.8}, {0, 0.8}}));
}

/// A star-shaped polygon: simple, rarely convex.
inline Polygon random_star(std::mt19937_64& rng) {
  std::uniform_real_distribution<double> radius(0.1, 1);
  std::uniform_int_distribution<int> corners(3, 25);
  std::vector<Eigen::Vector2d> v;
  const int n = corners(rng);
  for (int i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n, r = radius(rng);
    v.emplace_back(r * std::cos(a) + 0.3, r * std::sin(a) - 2);
  }
  return Polygon(columns(v));
}

inline Eigen::Vector2d random_point(const Polygon& polygon, std::mt19937_64& rng) {
  const Eigen::Vector2d lower = polygon.vertices().rowwise().minCoeff();
  const Eigen::Vector2d upper = polygon.vertices().rowwise().maxCoeff();
  std::uniform_real_distribution<double> u(-0.1, 1.1);
  return lower + (upper - lower).cwiseProduct(Eigen::Vector2d(u(rng), u(rng)));
}

}  // namespace graspless::geometry
