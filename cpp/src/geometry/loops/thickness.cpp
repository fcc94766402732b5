// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// How thick what a loop runs along is: cuts across it, and how far the points there spread.
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "graspless/geometry/loops.hpp"

#include "geometry/loops/shortest_basis.hpp"

namespace graspless::geometry {
namespace {

constexpr int kCuts = 48, kDirections = 12;
constexpr std::size_t kLeastPoints = 4;  // of a cut that says something
constexpr double kPi = 3.14159265358979323846;

/// A cut across the loop: the points near the plane, in its coordinates.
class Cut {
 public:
  Cut(const Complex& complex, const ClaspTarget& place, double half_width) : place_(place) {
    x_ = place.tangent.unitOrthogonal();
    y_ = place.tangent.cross(x_);
    for (Eigen::Index i = 0; i < complex.points.cols(); ++i) {
      const Eigen::Vector3d p = complex.points.col(i) - place.point;
      if (std::abs(p.dot(place.tangent)) <= half_width) points_.push_back({x_.dot(p), y_.dot(p)});
    }
  }

  /// The points that hang together with the loop's place by steps of `gap`: what it runs along, and
  /// not what else the plane cuts.
  std::vector<Eigen::Vector2d> piece(double gap) {
    std::vector<Eigen::Vector2d> piece, open{Eigen::Vector2d::Zero()};
    while (!open.empty()) {
      const Eigen::Vector2d from = open.back();
      open.pop_back();
      const auto far = [&](const Eigen::Vector2d& p) { return (p - from).norm() > gap; };
      const auto near = std::partition(points_.begin(), points_.end(), far);
      piece.insert(piece.end(), near, points_.end());
      open.insert(open.end(), near, points_.end());
      points_.erase(near, points_.end());
    }
    return piece;
  }

 private:
  const ClaspTarget& place_;
  Eigen::Vector3d x_, y_;
  std::vector<Eigen::Vector2d> points_;
};

/// The greatest width of planar points.
double width(const std::vector<Eigen::Vector2d>& points) {
  double widest = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = kPi * i / kDirections;
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    double lower = std::numeric_limits<double>::infinity(), upper = -lower;
    for (const Eigen::Vector2d& p : points) {
      lower = std::min(lower, p.dot(along));
      upper = std::max(upper, p.dot(along));
    }
    widest = std::max(widest, upper - lower);
  }
  return widest;
}

}  // namespace

double thickness(const Complex& complex, const Cycle& cycle) {
  const Eigen::Matrix3Xd loop = complex.points(Eigen::all, cycle);
  const double d = complex.max_edge_length;
  std::vector<double> widths;
  for (const ClaspTarget& place : clasp_targets(loop, kCuts)) {
    const std::vector<Eigen::Vector2d> piece = Cut(complex, place, d / 3).piece(d);
    if (piece.size() >= kLeastPoints) widths.push_back(width(piece));
  }
  if (widths.empty()) return 0;
  // The thinnest tenth: one cut alone may hit few points.
  const auto tenth = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 10);
  std::nth_element(widths.begin(), tenth, widths.end());
  return *tenth;
}

}  // namespace graspless::geometry
