// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses along a screw: logarithm and exponential of rigid motions.
#include "fingertip/realize_screw.hpp"

#include <cmath>

namespace graspless::fingertip {
namespace {

Eigen::Matrix3d cross(const Eigen::Vector3d& w) {
  Eigen::Matrix3d W;
  W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return W;
}

/// V of exp([w v]) = (exp [w], V v): the mean of the rotations along the way.
Eigen::Matrix3d mean_rotation(const Eigen::Vector3d& w) {
  const double a = w.norm();
  const Eigen::Matrix3d W = cross(w);
  if (a < 1e-4) return Eigen::Matrix3d::Identity() + W / 2 + W * W / 6;
  const double b = (1 - std::cos(a)) / (a * a), c = (a - std::sin(a)) / (a * a * a);
  return Eigen::Matrix3d::Identity() + b * W + c * W * W;
}

}  // namespace

Eigen::Isometry3d along_screw(const Eigen::Isometry3d& X_WA, const Eigen::Isometry3d& X_WB,
                              double s) {
  if (s <= 0) return X_WA;
  if (s >= 1) return X_WB;
  const Eigen::Isometry3d X_AB = X_WA.inverse() * X_WB;
  const Eigen::AngleAxisd turn(X_AB.linear());
  const Eigen::Vector3d w = turn.angle() * turn.axis();
  const Eigen::Vector3d v = mean_rotation(w).partialPivLu().solve(X_AB.translation());
  Eigen::Isometry3d X_AS;
  X_AS = Eigen::Translation3d(s * (mean_rotation(s * w) * v)) *
         Eigen::AngleAxisd(s * turn.angle(), turn.axis());
  return X_WA * X_AS;
}

}  // namespace graspless::fingertip
