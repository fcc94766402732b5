// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/resolution.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/pulse.hpp"
#include "geometry/quantile.hpp"

namespace graspless::geometry {
namespace {

constexpr std::size_t kNeighbors = 6;  // of a point inside an even cloud on a surface

/// Longest edge between neighbours relative to the spacing. In an even cloud no edge of a
/// triangulated surface exceeds it, in a random one 1 % do; holes between fewer points than that
/// are beyond the cloud's resolution.
constexpr double kReach = 2;

using Neighbor = std::pair<double, int>;  // distance [m], point

/// For each point, the nearest points that it shares an edge with, nearest first.
class NearestNeighbors {
 public:
  explicit NearestNeighbors(const Complex& complex)
      : first_(static_cast<std::size_t>(complex.points.cols()) + 1) {
    for (const int end : complex.edges.reshaped()) ++first_[static_cast<std::size_t>(end) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    all_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    Pulse pulse;
    for (const auto& edge : complex.edges.colwise()) {
      pulse();
      const double length = (complex.points.col(edge[0]) - complex.points.col(edge[1])).norm();
      all_[next[edge[0]]++] = {length, edge[1]};
      all_[next[edge[1]]++] = {length, edge[0]};
    }
    for (std::size_t point = 0; point + 1 < first_.size(); ++point) {
      pulse();
      std::partial_sort(begin(point), end(point), at(first_[point + 1]));
    }
  }

  using Iterator = std::vector<Neighbor>::iterator;
  Iterator begin(std::size_t point) { return at(first_[point]); }
  Iterator end(std::size_t point) {
    return at(std::min(first_[point] + kNeighbors, first_[point + 1]));
  }

 private:
  Iterator at(std::size_t i) { return all_.begin() + i; }

  std::vector<std::size_t> first_;  // of each point in all_, and the size of that
  std::vector<Neighbor> all_;
};

}  // namespace

Resolution::Resolution(const Complex& complex) : points_(complex.points) {
  NearestNeighbors neighbors(complex);
  const auto farthest = [&](std::size_t point) { return (neighbors.end(point) - 1)->first; };
  std::vector<double> values;
  Pulse pulse;
  for (std::size_t point = 0; point < static_cast<std::size_t>(points_.cols()); ++point) {
    pulse();
    values.clear();
    const auto begin = neighbors.begin(point), end = neighbors.end(point);
    if (begin != end) values.push_back(farthest(point));
    for (auto other = begin; other != end; ++other)
      values.push_back(farthest(static_cast<std::size_t>(other->second)));
    spacing_.push_back(values.empty() ? 0 : median(values));
  }
}

double Resolution::relative_length(int a, int b) const {
  return (points_.col(a) - points_.col(b)).norm() / std::min(spacing_[a], spacing_[b]);
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
  Pulse pulse;
  for (const auto& edge : complex.edges.colwise()) {
    pulse();
    if (resolution.is_gap(edge[0], edge[1])) continue;
    result.edges.col(edges++) = edge;
    result.max_edge_length = std::max(
        result.max_edge_length, (complex.points.col(edge[0]) - complex.points.col(edge[1])).norm());
  }
  for (const auto& corners : complex.triangles.colwise()) {
    pulse();
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
