// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

#include "carry/place_search.hpp"
#include "carry/search.hpp"
#include "planning/joints.hpp"

/// Straight motions of the hand, and tests of motions.
namespace graspless::carry {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;
using planning::Path;

namespace {

constexpr double kBranch = 0.25;  // a longer step has left the branch of the inverse [rad]

}  // namespace

/// Withdraws the hand along its way out, if there is one; else straight back along its own axis,
/// up, or away from the object.
std::optional<Path> PlaceSearch::withdrawn(const VectorXd& q) {
  if (!places_.way_out.empty()) return along_way_out(q);
  const Isometry3d X_WF = problem_.robot.pose(frame_, q);
  const Vector3d back = -X_WF.linear().col(2);
  const Vector3d away = X_WF.translation() - scene_.world().pose(object_).translation();
  for (const Vector3d& along : {back, places_.normal_W, Vector3d(back + places_.normal_W), away}) {
    if (along.norm() < 1e-3) continue;
    const auto poses = line(q, along.normalized(), options_.retreat);
    if (std::optional<Path> path = follow(q, poses)) return path;
  }
  return std::nullopt;
}

/// Moves the hand from q as on its way out, in its own frame.
std::optional<Path> PlaceSearch::along_way_out(const VectorXd& q) {
  const Isometry3d X_WF = problem_.robot.pose(frame_, q);
  const Isometry3d X_FW = problem_.robot.pose(frame_, places_.way_out.front()).inverse();
  Path path{q};
  for (const VectorXd& out : places_.way_out) {
    ++statistics_.ik_calls;
    const auto arm = ik_.solve_near(X_WF * X_FW * problem_.robot.pose(frame_, out), path.back());
    if (!arm) return std::nullopt;
    const planning::Joints joints{ik_.group(), out};
    const VectorXd next = joints.full(joints.part(*arm));
    if (problem_.robot.step(path.back(), next) > kBranch) return std::nullopt;
    if (!is_free(path.back(), next)) return std::nullopt;
    path.push_back(next);
  }
  return path;
}

/// Poses of the hand along a straight line from q, without turning.
std::vector<Isometry3d> PlaceSearch::line(const VectorXd& q, const Vector3d& along,
                                          double length) const {
  const Isometry3d X_WF = problem_.robot.pose(frame_, q);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kWaypoint)));
  std::vector<Isometry3d> poses;
  for (int i = 1; i <= steps; ++i)
    poses.push_back(Eigen::Translation3d(along * (length * i / steps)) * X_WF);
  return poses;
}

/// Moves the hand from q through poses on one branch of the inverse kinematics.
std::optional<Path> PlaceSearch::follow(const VectorXd& q, const std::vector<Isometry3d>& poses) {
  Path path{q};
  for (const Isometry3d& X_WF : poses) {
    ++statistics_.ik_calls;
    const auto next = ik_.solve_near(X_WF, path.back());
    if (!next || problem_.robot.step(path.back(), *next) > kBranch) return std::nullopt;
    if (!is_free(path.back(), *next)) return std::nullopt;
    path.push_back(*next);
  }
  return path;
}

/// True if the object's vertical is near that at the start or that at the places.
bool PlaceSearch::is_level(const VectorXd& q) const {
  const Vector3d up = object_at(q).linear() * up_O_;
  const Vector3d before = problem_.object.X_WB.linear() * up_O_;
  return std::max(up.dot(before), up.dot(places_.normal_W)) >=
         std::cos(std::min(options_.max_tilt, M_PI));
}

bool PlaceSearch::is_level(const VectorXd& from, const VectorXd& to) const {
  const int pieces = std::max(
      1,
      static_cast<int>(std::ceil(problem_.robot.step(from, to) / checked_step(from, to) - 1e-6)));
  for (int i = 0; i <= pieces; ++i) {
    poll();
    if (!is_level(from + (to - from) * i / pieces)) return false;
  }
  return true;
}

bool PlaceSearch::is_free(const VectorXd& from, const VectorXd& to) {
  return scene_.is_free(from, to, checked_step(from, to));
}

/// Length of the steps at which check() replays a straight motion, or a part of it [rad].
double PlaceSearch::checked_step(const VectorXd& from, const VectorXd& to) const {
  const double span = problem_.robot.step(from, to);
  if (span == 0) return options_.resolution;
  const double rows = std::max(1.0, std::ceil(span / kRowStep));
  const double pieces = rows * std::max(1.0, std::ceil(span / rows / options_.resolution));
  return span / pieces * (1 + 1e-12);
}

}  // namespace graspless::carry
