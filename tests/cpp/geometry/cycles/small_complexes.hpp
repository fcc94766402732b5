// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "graspless/geometry/complex.hpp"

/// Complexes written down by hand or drawn by lot, without a triangulation of a cloud behind them.
namespace graspless::geometry {

using EdgeSet = std::set<std::array<int, 2>>;
using TriangleSet = std::set<std::array<int, 3>>;

/// The edges of the triangles are added.
inline Complex complex_of(const Eigen::Matrix3Xd& points, EdgeSet edges,
                          const TriangleSet& triangles = {}) {
  for (const auto& [a, b, c] : triangles) edges.insert({{a, b}, {a, c}, {b, c}});
  Complex complex;
  complex.points = points;
  complex.edges.resize(2, static_cast<Eigen::Index>(edges.size()));
  complex.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  Eigen::Index next = 0;
  for (const auto& [a, b] : edges) {
    complex.edges.col(next++) << a, b;
    complex.max_edge_length =
        std::max(complex.max_edge_length, 1.001 * (points.col(a) - points.col(b)).norm());
  }
  next = 0;
  for (const auto& [a, b, c] : triangles) complex.triangles.col(next++) << a, b, c;
  return complex;
}

inline std::array<int, 2> edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

inline std::array<int, 3> triangle_of(int a, int b, int c) {
  std::array<int, 3> corners{a, b, c};
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Points of the unit cube joined where nearer than `reach`, a random share of the triangles
/// filled.
inline Complex random_complex(int n, double reach, double share, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::uniform_real_distribution<double> u(0, 1);
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::NullaryExpr(3, n, [&] { return u(rng); });
  const auto joined = [&](int a, int b) { return (points.col(a) - points.col(b)).norm() < reach; };
  EdgeSet edges;
  TriangleSet triangles;
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) {
      if (!joined(a, b)) continue;
      edges.insert({a, b});
      for (int c = b + 1; c < n; ++c) {
        if (joined(a, c) && joined(b, c) && u(rng) < share) triangles.insert({a, b, c});
      }
    }
  }
  return complex_of(points, edges, triangles);
}

/// A flat net of columns x rows squares of side `side`, each of two triangles; every `pitch`-th
/// square both ways is missing (0: none).
inline Complex net(int columns, int rows, double side, int pitch = 0) {
  const auto at = [&](int i, int j) { return i * (rows + 1) + j; };
  Eigen::Matrix3Xd points(3, (columns + 1) * (rows + 1));
  TriangleSet triangles;
  for (int i = 0; i <= columns; ++i) {
    for (int j = 0; j <= rows; ++j) points.col(at(i, j)) << i * side, j * side, 0;
  }
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      if (pitch > 0 && i % pitch == 1 && j % pitch == 1) continue;
      triangles.insert(triangle_of(at(i, j), at(i + 1, j), at(i + 1, j + 1)));
      triangles.insert(triangle_of(at(i, j), at(i, j + 1), at(i + 1, j + 1)));
    }
  }
  return complex_of(points, {}, triangles);
}

/// The surface of a ring about z, `along` points around the ring and `across` around its tube.
/// `first` of the `across` rows to `last` only: a part of the tube, as seen from one side.
inline Complex ring_surface(double radius, double tube, int along, int across, int first = 0,
                            int last = -1) {
  if (last < 0) last = across;
  const auto at = [&](int i, int k) { return (i % along) * across + k % across; };
  Eigen::Matrix3Xd points(3, along * across);
  TriangleSet triangles;
  for (int i = 0; i < along; ++i) {
    for (int k = 0; k < across; ++k) {
      const double u = 2 * M_PI * i / along, v = 2 * M_PI * (k + 0.5 * (i % 2)) / across;
      const double r = radius + tube * std::cos(v);
      points.col(at(i, k)) << r * std::cos(u), r * std::sin(u), tube * std::sin(v);
      if (k < first || k >= last) continue;
      const int left = i % 2 ? at(i + 1, k + 1) : at(i + 1, k);
      const int right = i % 2 ? at(i + 1, k + 2) : at(i + 1, k + 1);
      triangles.insert(triangle_of(at(i, k), left, i % 2 ? at(i, k + 1) : right));
      triangles.insert(triangle_of(at(i, k + 1), right, i % 2 ? left : at(i, k)));
    }
  }
  return complex_of(points, {}, triangles);
}

/// The same complex, its points in another order.
inline Complex relabelled(const Complex& complex, std::uint64_t seed) {
  std::vector<int> place(complex.points.cols());
  std::iota(place.begin(), place.end(), 0);
  std::mt19937_64 rng(seed);
  for (std::size_t i = place.size(); i > 1; --i) std::swap(place[i - 1], place[rng() % i]);
  const auto to = [&](int v) { return place[v]; };
  Eigen::Matrix3Xd points(3, complex.points.cols());
  for (int v = 0; v < complex.points.cols(); ++v) points.col(to(v)) = complex.points.col(v);
  EdgeSet edges;
  TriangleSet triangles;
  for (const auto& e : complex.edges.colwise()) edges.insert(edge_of(to(e[0]), to(e[1])));
  for (const auto& t : complex.triangles.colwise())
    triangles.insert(triangle_of(to(t[0]), to(t[1]), to(t[2])));
  return complex_of(points, edges, triangles);
}

}  // namespace graspless::geometry
