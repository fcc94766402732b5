// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/certificate/tight_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include <Eigen/Geometry>

#include "graspless/geometry/linking.hpp"
#include "graspless/watch.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;

/// Cone over a closed curve: triangles from an apex to its sides.
class Cone {
 public:
  Cone(const Eigen::Matrix3Xd& curve, int attempt) : corners_(curve) {
    const Vector3d middle = curve.rowwise().mean();
    const double size = (curve.colwise() - middle).cwiseAbs().maxCoeff();
    // Aside of the symmetries of hand-made curves, and elsewhere at each attempt.
    const double k = attempt + 1;
    const Vector3d aside(std::cos(1.7 * k), std::sin(2.9 * k), std::cos(4.3 * k + 1));
    apex_ = middle + 0.37 * size * aside;
    corners_.colwise() -= apex_;
    low_ = corners_.rowwise().minCoeff().cwiseMin(0);
    high_ = corners_.rowwise().maxCoeff().cwiseMax(0);
  }

  /// Signed number of times that the segment from p to q crosses the cone.
  int crossings(const Vector3d& p, const Vector3d& q) const {
    const Vector3d a = p - apex_, b = q - apex_;
    if ((a.cwiseMax(b).array() < low_.array()).any() ||
        (a.cwiseMin(b).array() > high_.array()).any())
      return 0;
    const Vector3d moment = a.cross(b);
    int sum = 0;
    for (Eigen::Index i = 0; i < corners_.cols(); ++i) {
      const Vector3d e = corners_.col(i), f = corners_.col((i + 1) % corners_.cols());
      const Vector3d normal = e.cross(f);
      const bool is_above = normal.dot(a) >= 0;
      if (is_above == (normal.dot(b) >= 0)) continue;
      // Sides of the line on which the two spokes and the rim pass.
      const double first = moment.dot(e), second = moment.dot(f), rim = (b - a).dot(normal);
      const double third = rim - first + second;
      if (!is_above && first >= 0 && second < 0 && third >= 0) ++sum;
      if (is_above && first < 0 && second >= 0 && third < 0) --sum;
    }
    return sum;
  }

 private:
  Eigen::Matrix3Xd corners_;
  Vector3d apex_, low_, high_;
};

/// Trees of points. Knows for each point the crossings on the way to its root.
class Forest {
 public:
  explicit Forest(Eigen::Index points) : parents_(points), counts_(points, 0) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }

  struct Place {
    int root, crossings;  // crossings on the way from the root to the point
  };
  Place find(int point) {
    const auto i = static_cast<std::size_t>(point);
    if (parents_[i] == point) return {point, 0};
    const Place above = find(parents_[i]);
    counts_[i] += above.crossings;
    parents_[i] = above.root;
    return {above.root, counts_[i]};
  }
  /// Joins the trees of two points; the way from a to b crosses `crossings` times.
  void join(const Place& a, const Place& b, int crossings) {
    parents_[b.root] = a.root;
    counts_[b.root] = a.crossings + crossings - b.crossings;
  }

 private:
  std::vector<int> parents_, counts_;
};

/// Way from a to b along edges of a forest.
std::vector<int> way(const std::vector<SpatialEdge>& edges, Eigen::Index points, int a, int b) {
  std::vector<std::vector<int>> next(points);
  for (const SpatialEdge& edge : edges) {
    next[edge.a].push_back(edge.b);
    next[edge.b].push_back(edge.a);
  }
  std::vector<int> from(points, -1), open{b};
  from[b] = b;
  while (from[a] < 0) {
    const int at = open.back();
    open.pop_back();
    for (const int to : next[at]) {
      if (from[to] >= 0) continue;
      from[to] = at;
      open.push_back(to);
    }
  }
  std::vector<int> result{a};
  while (result.back() != b) result.push_back(from[result.back()]);
  return result;
}

std::vector<int> first_cycle(const Eigen::Matrix3Xd& points, const std::vector<SpatialEdge>& edges,
                             const Cone& cone) {
  Forest forest(points.cols());
  std::vector<SpatialEdge> kept;
  for (const SpatialEdge& edge : edges) {
    poll();
    const int crossings = cone.crossings(points.col(edge.a), points.col(edge.b));
    const Forest::Place a = forest.find(edge.a), b = forest.find(edge.b);
    if (a.root != b.root) {
      forest.join(a, b, crossings);
      kept.push_back(edge);
    } else if (a.crossings + crossings != b.crossings) {
      return way(kept, points.cols(), edge.a, edge.b);
    }
  }
  return {};
}

}  // namespace

std::vector<int> tightest_cycle(const Eigen::Matrix3Xd& points, std::vector<SpatialEdge> edges,
                                const Eigen::Matrix3Xd& curve) {
  constexpr int kAttempts = 5;  // where the cone grazes a point, its number is a matter of rounding
  std::stable_sort(edges.begin(), edges.end(),
                   [](const auto& a, const auto& b) { return a.width < b.width; });
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::vector<int> cycle = first_cycle(points, edges, Cone(curve, attempt));
    if (cycle.empty()) break;
    if (cycle.size() >= 3 && geometry::linking_number(curve, points(Eigen::all, cycle)) != 0)
      return cycle;
  }
  return {};
}

}  // namespace graspless::clasp
