// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// check(): the target is one that the problem allows, and the hand is there.
#include <algorithm>
#include <cmath>
#include <limits>

#include "clasp/check/checker.hpp"
#include "clasp/search/pull.hpp"
#include "geometry/segment.hpp"

namespace graspless::clasp {
namespace {

constexpr double kChord = 0.025;    // fraction of the loop's length to either side of the target
constexpr double kMinCosine = 0.5;  // between tangent and chord, because loops of clouds zigzag
constexpr double kNear = 0.4;       // distance from the hand to the target, by the longest curve

/// Point of a closed polyline nearest to p.
Eigen::Vector3d nearest_point(const Eigen::Matrix3Xd& loop, const Eigen::Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  Eigen::Vector3d nearest = p;
  for (Eigen::Index i = 0; i < loop.cols(); ++i) {
    const Eigen::Vector3d a = loop.col(i), b = loop.col((i + 1) % loop.cols());
    const Eigen::Vector3d q = a + geometry::nearest_on_segment(p, a, b) * (b - a);
    if ((q - p).norm() >= least) continue;
    least = (q - p).norm();
    nearest = q;
  }
  return nearest;
}

double distance(const Eigen::Matrix3Xd& loop, const Eigen::Vector3d& p) {
  return (nearest_point(loop, p) - p).norm();
}

/// Points of a closed polyline at equal arc length.
Eigen::Matrix3Xd resampled(const Eigen::Matrix3Xd& loop, int count) {
  double length = 0;
  for (Eigen::Index i = 0; i < loop.cols(); ++i)
    length += (loop.col((i + 1) % loop.cols()) - loop.col(i)).norm();
  Eigen::Matrix3Xd points(3, count);
  double before = 0;
  Eigen::Index side = 0;
  for (int k = 0; k < count; ++k) {
    const double arc = length * k / count;
    double end = before + (loop.col((side + 1) % loop.cols()) - loop.col(side)).norm();
    while (end < arc && side + 1 < loop.cols()) {
      before = end;
      ++side;
      end = before + (loop.col((side + 1) % loop.cols()) - loop.col(side)).norm();
    }
    const double t = end > before ? (arc - before) / (end - before) : 0;
    points.col(k) = loop.col(side) + t * (loop.col((side + 1) % loop.cols()) - loop.col(side));
  }
  return points;
}

}  // namespace

Eigen::Matrix3Xd PlanChecker::loop_W() const {
  return (problem_.X_WO.linear() * loop_points()).colwise() + problem_.X_WO.translation();
}

/// The target lies on an allowed loop, at a mark if there are any, and the hand is there.
void PlanChecker::check_target() {
  const auto& allowed = problem_.loops;
  if (!allowed.empty() && std::find(allowed.begin(), allowed.end(), plan_.loop) == allowed.end())
    fault("plan", "loop ", plan_.loop, " is not one of those that may be clasped");
  const Eigen::Vector3d& point = plan_.target.point;
  if (!point.allFinite() || !(distance(loop_points(), point) <= kTolerance)) {
    fault("plan", "the target does not lie on its loop");
    return;
  }
  if (!problem_.marks.empty() && !is_marked())
    fault("plan", "the target is none of the marked places");
  check_tangent();
  check_pull();
  check_hand_at_target();
}

/// The target of a mark is the nearest point of the nearest allowed loop.
bool PlanChecker::is_marked() const {
  const auto& loops = problem_.object.loops().found;
  const auto is_nearest_loop = [&](const Eigen::Vector3d& mark) {
    const double own = distance(loop_points(), mark);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      const auto& only = problem_.loops;
      const bool may_be =
          only.empty() || std::find(only.begin(), only.end(), static_cast<int>(i)) != only.end();
      if (may_be && distance(loops[i].points, mark) < own - kTolerance) return false;
    }
    return true;
  };
  return std::any_of(problem_.marks.begin(), problem_.marks.end(), [&](const auto& mark) {
    return is_nearest_loop(mark) &&
           (nearest_point(loop_points(), mark) - plan_.target.point).norm() <= kTolerance;
  });
}

void PlanChecker::check_tangent() {
  constexpr int kPoints = 400, kReach = static_cast<int>(kPoints * kChord);
  const Eigen::Matrix3Xd points = resampled(loop_points(), kPoints);
  Eigen::Index at = 0;
  (points.colwise() - plan_.target.point).colwise().squaredNorm().minCoeff(&at);
  const Eigen::Vector3d chord =
      points.col((at + kReach) % kPoints) - points.col((at + kPoints - kReach) % kPoints);
  const Eigen::Vector3d& tangent = plan_.target.tangent;
  const bool is_unit = std::abs(tangent.norm() - 1) <= kTolerance;
  if (!is_unit || std::abs(tangent.dot(chord)) < kMinCosine * chord.norm())
    fault("plan", "the target's tangent is not the unit direction of its loop there");
}

/// The handle must lie across the pull, on the side of the loop in the direction of the pull.
void PlanChecker::check_pull() {
  if (!problem_.pull_W) return;
  const Eigen::Vector3d pull = problem_.X_WO.linear().transpose() * problem_.pull_W->normalized();
  const Eigen::Vector3d out = plan_.target.point - loop_points().rowwise().mean();
  if (std::abs(plan_.target.tangent.dot(pull)) > kMaxAlong + kTolerance ||
      out.dot(pull) < (kMinOutward - kTolerance) * out.norm()) {
    fault("plan", "the target is not good for the pull");
  }
}

/// The distance from the centre of the finger curves to the target is at most kNear of the longest
/// curve's length.
void PlanChecker::check_hand_at_target() {
  double longest = 0;
  Eigen::Vector3d lower, upper;
  lower.setConstant(std::numeric_limits<double>::infinity());
  upper = -lower;
  for (int i = 0; i < static_cast<int>(problem_.hand.fingers.size()); ++i) {
    const Eigen::Matrix3Xd curve = curve_in_world(problem_, i, q_end());
    double length = 0;
    for (Eigen::Index k = 1; k < curve.cols(); ++k)
      length += (curve.col(k) - curve.col(k - 1)).norm();
    longest = std::max(longest, length);
    lower = lower.cwiseMin(curve.rowwise().minCoeff());
    upper = upper.cwiseMax(curve.rowwise().maxCoeff());
  }
  const double away = (problem_.X_WO * plan_.target.point - (lower + upper) / 2).norm();
  if (away > kNear * longest) fault("plan", "the hand ends ", away, " m away from its target");
}

}  // namespace graspless::clasp
