// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pinch/face_measure.hpp"

#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

namespace graspless::pinch {

using Eigen::Vector2d;

namespace {

constexpr double kHalf = 0.004;                     // [m]
constexpr double kBehind = 0.008, kSpacing = 2e-4;  // of what counts as the face [m]
constexpr double kSlack = 0.10;                     // of slopes that are measured in two ways

/// Sums over points of an outline, for the line that fits them best.
struct Fit {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  void add(double u, double v) { n += 1, x += u, y += v, xx += u * u, xy += u * v; }
  std::optional<double> slope() const {
    const double spread = n > 0 ? xx - x * x / n : 0;
    if (spread <= 0) return std::nullopt;
    return (xy - x * y / n) / spread;
  }
};

}  // namespace

std::optional<double> steepest_around(const geometry::Polygon& outline, const Vector2d& contact,
                                      const Vector2d& outward) {
  const Vector2d along(-outward.y(), outward.x());
  Fit left, right, both;
  for (int k = 0; k < outline.size(); ++k) {
    poll();
    const geometry::Polygon::Edge edge = outline.edge(k);
    if (edge.inward.dot(outward) >= 0) continue;  // it faces the other way
    const int count = std::max(1, static_cast<int>((edge.b - edge.a).norm() / kSpacing));
    for (int j = 0; j < count; ++j) {
      const Vector2d off = edge.a + (edge.b - edge.a) * (j + 0.5) / count - contact;
      const double u = along.dot(off), v = outward.dot(off);
      if (std::abs(u) > kHalf || std::abs(v) > kBehind) continue;
      both.add(u, v);
      (u < 0 ? left : right).add(u, v);
    }
  }
  std::optional<double> steepest = both.slope();
  if (!steepest) return std::nullopt;
  for (const Fit& side : {left, right}) {
    const std::optional<double> slope = side.slope();
    if (slope && std::abs(*slope) > std::abs(*steepest)) steepest = slope;
  }
  return steepest;
}

double least_friction(double slope) {
  return std::tan(std::max(0.0, std::atan(std::abs(slope)) - kSlack));
}

bool is_held(double slope, double friction) {
  return std::atan(std::abs(slope)) <= std::atan(friction) + kSlack;
}

}  // namespace graspless::pinch
