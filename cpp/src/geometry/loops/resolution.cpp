// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/resolution.hpp"

#include <algorithm>
#include <utility>

#include "graspless/watch.hpp"

namespace graspless::geometry {
namespace {

constexpr std::size_t kNeighbors = 6;  // of a point inside an even cloud on a surface

/// Longest edge between neighbours relative to the spacing. In an even cloud no edge of a
/// triangulated surface exceeds it, in a random one 1 % do; holes between fewer points than that
/// are beyond the cloud's resolution.
constexpr double kReach = 2;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

using Neighbor = std::pair<double, int>;  // distance [m], point

/// For each point, the nearest points that it shares an edge with, nearest first.
std::vector<std::vector<Neighbor>> nearest_neighbors(const Complex& complex) {
  std::vector<std::vector<Neighbor>> all(static_cast<std::size_t>(complex.points.cols()));
  for (const auto& edge : complex.edges.colwise()) {
    poll();
    const double length = (complex.points.col(edge[0]) - complex.points.col(edge[1])).norm();
    all[static_cast<std::size_t>(edge[0])].emplace_back(length, edge[1]);
    all[static_cast<std::size_t>(edge[1])].emplace_back(length, edge[0]);
  }
  for (auto& neighbors : all) {
    poll();
    const std::size_t count = std::min(kNeighbors, neighbors.size());
    std::partial_sort(neighbors.begin(), neighbors.begin() + static_cast<std::ptrdiff_t>(count),
                      neighbors.end());
    neighbors.resize(count);
  }
  return all;
}

}  // namespace

Resolution::Resolution(const Complex& complex) : points_(complex.points) {
  const auto neighbors = nearest_neighbors(complex);
  std::vector<double> values;
  for (const auto& of_point : neighbors) {
    poll();
    values.clear();
    if (!of_point.empty()) values.push_back(of_point.back().first);
    for (const auto& [distance, other] : of_point)
      values.push_back(neighbors[static_cast<std::size_t>(other)].back().first);
    spacing_.push_back(values.empty() ? 0 : median(values));
  }
}

double Resolution::relative_length(int a, int b) const {
  return (points_.col(a) - points_.col(b)).norm() /
         std::min(spacing_[static_cast<std::size_t>(a)], spacing_[static_cast<std::size_t>(b)]);
}

bool Resolution::is_gap(int a, int b) const { return relative_length(a, b) > kReach; }

double Resolution::widest_gap(const Cycle& cycle) const {
  double widest = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const int a = cycle[i], b = cycle[(i + 1) % cycle.size()];
    if (is_gap(a, b)) widest = std::max(widest, (points_.col(a) - points_.col(b)).norm());
  }
  return widest;
}

Complex surface_of(const Complex& complex, const Resolution& resolution) {
  Complex result;
  result.points = complex.points;
  result.edges.resize(2, complex.edges.cols());
  result.triangles.resize(3, complex.triangles.cols());
  Eigen::Index edges = 0, triangles = 0;
  for (const auto& edge : complex.edges.colwise()) {
    poll();
    if (resolution.is_gap(edge[0], edge[1])) continue;
    result.edges.col(edges++) = edge;
    result.max_edge_length = std::max(
        result.max_edge_length, (complex.points.col(edge[0]) - complex.points.col(edge[1])).norm());
  }
  for (const auto& corners : complex.triangles.colwise()) {
    poll();
    if (resolution.is_gap(corners[0], corners[1]) || resolution.is_gap(corners[0], corners[2]) ||
        resolution.is_gap(corners[1], corners[2]))
      continue;
    result.triangles.col(triangles++) = corners;
  }
  if (edges == complex.edges.cols()) result.max_edge_length = complex.max_edge_length;
  result.edges.conservativeResize(2, edges);
  result.triangles.conservativeResize(3, triangles);
  return result;
}

}  // namespace graspless::geometry
