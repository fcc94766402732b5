// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/polish.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace graspless::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kIterations = 12;
constexpr double kLongestStep = 0.3;  // of one joint [rad]
constexpr double kSingularDamping =
    1e-2;  // of the squared error, where a full step would be too long

}  // namespace

bool Polish::operator()(const Eigen::Isometry3d& X_PE, double* q) const {
  Matrix6d J;
  for (int iteration = 0;; ++iteration) {
    const Vector6d error = error_and_jacobian(X_PE, q, J);
    const double square = error.squaredNorm();
    if (square <= kTolerance * kTolerance) return true;
    if (iteration == kIterations || !(square < 1)) return false;
    Vector6d dq = J.partialPivLu().solve(error);
    if (!(dq.cwiseAbs().maxCoeff() <= kLongestStep)) {  // nearly singular
      Matrix6d A = J.transpose() * J;
      A.diagonal().array() += kSingularDamping * square + 1e-16;
      dq = A.ldlt().solve(J.transpose() * error);
      if (!(dq.cwiseAbs().maxCoeff() <= 1)) return false;
    }
    for (int i = 0, column = 0; i < size; ++i) {
      if (i != held) q[i] += dq[column++];
    }
  }
}

/// Returns the twist that is missing, with its moment about P's origin, linear part first.
Polish::Vector6d Polish::error_and_jacobian(const Eigen::Isometry3d& X_PE, const double* q,
                                            Matrix6d& J) const {
  Matrix3d R = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero();  // R, p: motion of the links so far
  for (int i = 0, column = 0; i < size; ++i) {
    const auto& [axis, point] = screws[i];
    const Vector3d axis_now = R * axis, point_now = R * point + p;
    if (i != held) J.col(column++) << point_now.cross(axis_now), axis_now;
    const Turn turn = Turn::by(q[i]);
    for (int k = 0; k < 3; ++k) R.col(k) = turn.apply(axis_now, R.col(k));
    p = point_now - R * point;
  }
  const Matrix3d R_now = R * X_PE_zero.linear();
  const Vector3d p_now = R * X_PE_zero.translation() + p, p_to = X_PE.translation();
  // Half the sum of the columns' cross products is the axis times the sine of the angle.
  Vector3d turn = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) turn += 0.5 * R_now.col(k).cross(X_PE.linear().col(k));
  if (R_now.cwiseProduct(X_PE.linear()).sum() < 0) turn.setConstant(1);  // over a right angle
  Vector6d error;
  error << p_to - p_now - turn.cross(p_now), turn;
  return error;
}

}  // namespace graspless::robot
