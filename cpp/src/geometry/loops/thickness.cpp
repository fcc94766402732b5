// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Thickness of the handle that a loop runs along: the width of cross-sections of the cloud.
#include "geometry/loops/thickness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "graspless/geometry/loops.hpp"

#include "geometry/sampling/hilbert_order.hpp"

namespace graspless::geometry {
namespace {

constexpr int kSections = 48, kDirections = 12;
constexpr std::size_t kMinPoints = 4;  // of a cross-section that counts

/// The points of a cloud in balls of few neighbours, to find those near a plane.
class Balls {
 public:
  explicit Balls(const Eigen::Matrix3Xd& points)
      : points_(points(Eigen::all, morton_order(points))) {
    const double rounding = 1e-9 * points.cwiseAbs().maxCoeff();
    for (Eigen::Index first = 0; first < points_.cols(); first += kPoints) {
      const auto members = points_.middleCols(first, std::min(kPoints, points_.cols() - first));
      const Eigen::Vector3d middle = members.rowwise().mean();
      const double radius = (members.colwise() - middle).colwise().norm().maxCoeff();
      balls_.push_back({middle, radius + rounding});
    }
  }

  /// Calls `visit` with all points of the balls that are within a distance of a plane.
  template <class Visit>
  void near(const ClaspTarget& plane, double distance, const Visit& visit) const {
    Eigen::Index first = 0;
    for (const Ball& ball : balls_) {
      const Eigen::Index last = std::min(first + kPoints, points_.cols());
      if (std::abs((ball.middle - plane.point).dot(plane.tangent)) <= distance + ball.radius) {
        for (Eigen::Index i = first; i < last; ++i) visit(points_.col(i));
      }
      first = last;
    }
  }

 private:
  static constexpr Eigen::Index kPoints = 16;
  struct Ball {
    Eigen::Vector3d middle;
    double radius;
  };
  Eigen::Matrix3Xd points_;  // the same number for each ball
  std::vector<Ball> balls_;
};

/// A cross-section of the loop: the points near a plane across it, in coordinates of the plane.
class CrossSection {
 public:
  CrossSection(const Balls& balls, const ClaspTarget& center, double half_width) {
    const Eigen::Vector3d x = center.tangent.unitOrthogonal(), y = center.tangent.cross(x);
    balls.near(center, half_width, [&](const auto& point) {
      const Eigen::Vector3d p = point - center.point;
      if (std::abs(p.dot(center.tangent)) <= half_width) points_.push_back({x.dot(p), y.dot(p)});
    });
  }

  /// Removes and returns the points connected to the loop by steps of at most `gap`: the handle,
  /// without other parts that the plane cuts.
  std::vector<Eigen::Vector2d> take_connected(double gap) {
    constexpr double kRounding = 1e-9;
    const double least = gap * gap * (1 - kRounding), most = gap * gap * (1 + kRounding);
    std::vector<Eigen::Vector2d> piece, open{Eigen::Vector2d::Zero()};
    while (!open.empty()) {
      const Eigen::Vector2d from = open.back();
      open.pop_back();
      const auto far = [&](const Eigen::Vector2d& p) {
        const double squared = (p - from).squaredNorm();
        return squared > most || (squared >= least && std::sqrt(squared) > gap);
      };
      const auto near = std::partition(points_.begin(), points_.end(), far);
      piece.insert(piece.end(), near, points_.end());
      open.insert(open.end(), near, points_.end());
      points_.erase(near, points_.end());
    }
    return piece;
  }

 private:
  std::vector<Eigen::Vector2d> points_;
};

/// Smallest and largest width of planar points over a few directions [m].
std::pair<double, double> widths_of(const std::vector<Eigen::Vector2d>& points) {
  double narrowest = std::numeric_limits<double>::infinity(), widest = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = M_PI * i / kDirections;
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    double lower = std::numeric_limits<double>::infinity(), upper = -lower;
    for (const Eigen::Vector2d& p : points) {
      lower = std::min(lower, p.dot(along));
      upper = std::max(upper, p.dot(along));
    }
    widest = std::max(widest, upper - lower);
    narrowest = std::min(narrowest, upper - lower);
  }
  return {narrowest, widest};
}

/// A low quantile instead of the minimum: a single cross-section may hit few points.
double tenth(std::vector<double> values) {
  const auto at = values.begin() + (values.size() / 10);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// 0, unknown, where more than a quarter of the sections has too few points: those of a thin handle
/// would leave the thickness to what it hangs on.
Thickness thickness_along(const Eigen::Matrix3Xd& loop, const Balls& balls, double d) {
  std::vector<double> narrowest, widest;
  const std::vector<ClaspTarget> centers = clasp_targets(loop, kSections);
  for (const ClaspTarget& center : centers) {
    const std::vector<Eigen::Vector2d> piece = CrossSection(balls, center, d / 3).take_connected(d);
    if (piece.size() < kMinPoints) continue;
    const auto [least, most] = widths_of(piece);
    narrowest.push_back(least);
    widest.push_back(most);
  }
  if (widest.empty() || 4 * widest.size() < 3 * centers.size()) return {};
  return {tenth(std::move(widest)), tenth(std::move(narrowest))};
}

}  // namespace

std::vector<Thickness> thickness(const Complex& complex, const std::vector<Cycle>& cycles) {
  std::vector<Thickness> result;
  if (cycles.empty()) return result;
  const Balls balls(complex.points);
  for (const Cycle& cycle : cycles) {
    result.push_back(
        thickness_along(complex.points(Eigen::all, cycle), balls, complex.max_edge_length));
  }
  return result;
}

}  // namespace graspless::geometry
