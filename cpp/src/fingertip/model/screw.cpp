// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Logarithm and exponential of SE(3), and paths of one degree of freedom: slides, turns, and one
// after another.
#include "fingertip/model/screw.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "graspless/fingertip/problem.hpp"
#include "graspless/geometry/pose.hpp"

#include "text.hpp"

namespace graspless::fingertip {
namespace {

using mechanics::Vector6d;

Eigen::Matrix3d skew(const Eigen::Vector3d& w) {
  Eigen::Matrix3d W;
  W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return W;
}

/// (1 - a) / theta^2 and the like lose their digits below this angle [rad]; series take over.
constexpr double kSmallAngle = 1e-3;

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  const double sine = q.vec().norm();
  if (sine == 0) return Eigen::Vector3d::Zero();
  const double angle = 2 * std::atan2(sine, std::abs(q.w()));
  return (q.w() < 0 ? -angle : angle) / sine * q.vec();
}

constexpr double kJoint = 1e-6;  // how well paths must meet [m, rad]

void require_segments(int segments) {
  if (segments >= 1 && segments < kMaxPoses) return;
  throw std::invalid_argument("segments must be 1 to " + std::to_string(kMaxPoses - 1) + ", not " +
                              std::to_string(segments));
}

}  // namespace

Vector6d screw_between(const Eigen::Isometry3d& X_WO, const Eigen::Isometry3d& X_WO_next) {
  const Eigen::Matrix3d R = X_WO.linear().transpose() * X_WO_next.linear();
  const Eigen::Vector3d p =
      X_WO.linear().transpose() * (X_WO_next.translation() - X_WO.translation());
  const Eigen::Vector3d w = rotation_vector(R);
  const double angle = w.norm();
  const double c = angle < kSmallAngle ? 1.0 / 12 + angle * angle / 720
                                       : (1 - angle / 2 / std::tan(angle / 2)) / (angle * angle);
  Vector6d twist;
  twist << p - w.cross(p) / 2 + c * w.cross(w.cross(p)), w;
  return twist;
}

Eigen::Isometry3d along_screw(const Eigen::Isometry3d& X_WO, const Vector6d& twist_O, double part) {
  const Eigen::Vector3d v = part * twist_O.head<3>(), w = part * twist_O.tail<3>();
  const double angle = w.norm(), square = angle * angle;
  const bool is_small = angle < kSmallAngle;
  const double a = is_small ? 1 - square / 6 : std::sin(angle) / angle;
  const double b = is_small ? 0.5 - square / 24 : (1 - std::cos(angle)) / square;
  const double c = is_small ? 1.0 / 6 - square / 120 : (1 - a) / square;
  const Eigen::Matrix3d W = skew(w);
  Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
  step.linear() += a * W + b * W * W;
  step.translation() = v + b * w.cross(v) + c * w.cross(w.cross(v));
  return X_WO * step;
}

mechanics::BodyState moving_state(const Eigen::Isometry3d& X_WO, const Vector6d& twist_O) {
  mechanics::BodyState state;
  state.X_WO = X_WO;
  state.twist_W << X_WO.linear() * twist_O.head<3>(), X_WO.linear() * twist_O.tail<3>();
  return state;
}

mechanics::BodyState resting_state(const Eigen::Isometry3d& X_WO, const Vector6d& twist_O) {
  mechanics::BodyState state = moving_state(X_WO, twist_O);
  state.at_rest = true;
  return state;
}

Path slide_path(const Eigen::Isometry3d& X_WO_start, const Eigen::Vector3d& translation_W,
                int segments) {
  geometry::require_pose(X_WO_start, "X_WO_start");
  require_segments(segments);
  if (!(translation_W.allFinite() && translation_W.norm() > 0)) {
    throw std::invalid_argument("translation_W must be finite and not zero");
  }
  Path path;
  for (int i = 0; i <= segments; ++i) {
    Eigen::Isometry3d X_WO = X_WO_start;
    X_WO.translation() += translation_W * i / segments;
    path.X_WO.push_back(X_WO);
  }
  return path;
}

Path turn_path(const Eigen::Isometry3d& X_WO_start, const Eigen::Vector3d& point_W,
               const Eigen::Vector3d& axis_W, double angle, int segments) {
  geometry::require_pose(X_WO_start, "X_WO_start");
  require_segments(segments);
  if (!(axis_W.allFinite() && axis_W.norm() > 0 && point_W.allFinite())) {
    throw std::invalid_argument("axis_W must be finite and not zero, and point_W finite");
  }
  require(std::abs(angle) > 0 && std::isfinite(angle), "angle", angle,
          "must be finite and not zero");
  if (!(std::abs(angle) <= kMaxTurn * segments)) {
    throw std::invalid_argument("angle " + figure(angle) + " rad: each of the segments (" +
                                std::to_string(segments) + ") may turn by 3 rad at most");
  }
  const Eigen::Translation3d to_point(point_W), from_point(-point_W);
  Path path;
  for (int i = 0; i <= segments; ++i) {
    const Eigen::AngleAxisd turn(angle * i / segments, axis_W.normalized());
    path.X_WO.push_back(to_point * turn * from_point * X_WO_start);
  }
  return path;
}

Path join(const std::vector<Path>& paths) {
  Path all;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].X_WO.empty()) {
      throw std::invalid_argument("paths[" + std::to_string(i) + "] must not be empty");
    }
    auto first = paths[i].X_WO.begin();
    if (i > 0) {
      const mechanics::Vector6d gap = screw_between(all.X_WO.back(), *first);
      if (!(gap.cwiseAbs().maxCoeff() <= kJoint)) {
        throw std::invalid_argument(
            "paths[" + std::to_string(i) + "] must start where the one before ends, but is " +
            figure(gap.head<3>().norm()) + " m and " + figure(gap.tail<3>().norm()) + " rad away");
      }
      ++first;
    }
    all.X_WO.insert(all.X_WO.end(), first, paths[i].X_WO.end());
  }
  return all;
}

}  // namespace graspless::fingertip
