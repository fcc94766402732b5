// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "carry/straight_path.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::carry {
namespace {

constexpr double kShort = 1e-6;  // [m]; a shorter path is a turn on the spot

}  // namespace

StraightPath::StraightPath(const Eigen::Isometry3d& X_WO_start, const Eigen::Isometry3d& X_WO_goal)
    : start_(X_WO_start),
      along_(X_WO_goal.translation() - X_WO_start.translation()),
      turn_(Eigen::Matrix3d(X_WO_start.linear().transpose() * X_WO_goal.linear())) {
  axis_ = along_.norm() > kShort ? Eigen::Vector3d(along_.normalized())
                                 : Eigen::Vector3d(start_.linear() * turn_.axis());
}

Eigen::Isometry3d StraightPath::pose(double s, double twist) const {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = start_.translation() + s * along_;
  X.linear() = Eigen::AngleAxisd(twist, axis_) * start_.linear() *
               Eigen::AngleAxisd(s * turn_.angle(), turn_.axis());
  return X;
}

bool StraightPath::contains(const Eigen::Isometry3d& X_WO, const Options& options) const {
  const Eigen::Vector3d p = X_WO.translation() - start_.translation();
  const Eigen::Matrix3d R = start_.linear().transpose() * X_WO.linear();
  const Eigen::AngleAxisd turned(R);
  const double part = along_.norm() > kShort
                          ? p.dot(along_) / along_.squaredNorm()
                          : turned.angle() * std::abs(turned.axis().dot(turn_.axis())) /
                                turn_.angle();  // half a turn has either sign
  const double s = std::clamp(part, 0.0, 1.0);
  if ((p - s * along_).norm() > options.tolerance) return false;
  const Eigen::Quaterniond off(Eigen::Matrix3d(X_WO.linear() * pose(s, 0).linear().transpose()));
  const double about = 2 * std::atan2(off.vec().dot(axis_), off.w());
  const double twist =
      std::clamp(std::remainder(about, 2 * M_PI), -options.max_twist, options.max_twist);
  const Eigen::Matrix3d rest =
      Eigen::AngleAxisd(-twist, axis_).toRotationMatrix() * off.toRotationMatrix();
  return Eigen::AngleAxisd(rest).angle() <= options.angle_tolerance;
}

}  // namespace graspless::carry
