// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "graspless/geometry/loops.hpp"

#include "geometry/require_points.hpp"
#include "text.hpp"

namespace graspless::geometry {
namespace {

constexpr int kMostTargets = 1000000;

/// A closed polyline parametrised by arc length.
class ClosedCurve {
 public:
  explicit ClosedCurve(const Eigen::Matrix3Xd& loop) : loop_(loop) {
    for (Eigen::Index i = 0; i < loop.cols(); ++i) {
      ends_.push_back(length() + (loop.col((i + 1) % loop.cols()) - loop.col(i)).norm());
    }
  }
  double length() const { return ends_.empty() ? 0 : ends_.back(); }

  /// Point at arc length s, which is taken modulo the length [m].
  Eigen::Vector3d at(double s) const {
    s -= std::floor(s / length()) * length();
    const auto end = std::upper_bound(ends_.begin(), ends_.end() - 1, s);
    const Eigen::Index i = end - ends_.begin();
    const double begin = i > 0 ? *(end - 1) : 0;
    const double share = *end > begin ? std::min(1.0, (s - begin) / (*end - begin)) : 0;
    return (1 - share) * loop_.col(i) + share * loop_.col((i + 1) % loop_.cols());
  }

 private:
  const Eigen::Matrix3Xd& loop_;
  std::vector<double> ends_;  // arc length at the end of each segment [m]
};

}  // namespace

std::vector<ClaspTarget> clasp_targets(const Eigen::Matrix3Xd& loop, int count) {
  require_points(loop, "loop");
  require_within("count", count, 1, kMostTargets);
  const ClosedCurve curve(loop);
  if (loop.cols() < 3 || !(curve.length() > 0)) {
    throw std::invalid_argument("loop must have at least 3 corners and a length, not " +
                                std::to_string(loop.cols()) + " corners and " +
                                figure(curve.length()) + " m");
  }
  // With one or two targets the chord would span the whole loop.
  const double step = curve.length() / count, half = curve.length() / std::max(2 * count, 16);
  std::vector<ClaspTarget> targets;
  for (int i = 0; i < count; ++i) {
    const double s = i * step;
    Eigen::Vector3d chord = curve.at(s + half) - curve.at(s - half);
    // The chord vanishes where a loop runs back along itself. The chord ahead replaces it.
    if (!(chord.norm() > 1e-9 * curve.length())) chord = curve.at(s + half) - curve.at(s);
    if (!(chord.norm() > 0)) chord = Eigen::Vector3d::UnitX();
    targets.push_back({curve.at(s), chord.normalized()});
  }
  return targets;
}

}  // namespace graspless::geometry
