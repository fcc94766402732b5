// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/damped_least_squares.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace graspless::robot {
namespace {

constexpr double kDamping = 0.05;  // of the squared error
constexpr double kLeastDamping = 1e-14;
constexpr double kMaxStep = 0.5;  // of one joint [rad or m]
constexpr double kPull = 0.3;     // fraction of the distance to the middle of the limits, per step
constexpr double kPlaced = 0.02;  // distance from which a frame that may lean is placed exactly [m]
constexpr double kTurnWeight = 0.01;  // of its angles then, beside its position
constexpr double kSettled = 0.999;    // a step that leaves more of the angle turns it no further

}  // namespace

Eigen::Matrix<double, 6, 1> pose_error(const Eigen::Isometry3d& X_WA,
                                       const Eigen::Isometry3d& X_WB) {
  const Eigen::Quaterniond turn(Eigen::Matrix3d(X_WB.linear() * X_WA.linear().transpose()));
  const double sine = turn.vec().norm();
  const double angle = 2 * std::atan2(sine, std::abs(turn.w()));
  const double scale = sine > 1e-12 ? angle / sine : 2;
  Eigen::Matrix<double, 6, 1> error;
  error << X_WB.translation() - X_WA.translation(), (turn.w() < 0 ? -scale : scale) * turn.vec();
  return error;
}

bool DampedLeastSquares::solve(const Eigen::Isometry3d& X_WF, const Ik::Options& options, bool pull,
                               Eigen::VectorXd& q) {
  bool was_placed = false;
  double last_angle = 0;
  for (int iteration = 0;; ++iteration) {
    robot_.forward_to(frame_, q, X_WL_);
    const Vector6d error = pose_error(X_WL_[frame_], X_WF);
    const double distance = error.head<3>().norm(), angle = error.tail<3>().norm();
    const bool is_placed = distance <= options.tolerance;
    const bool has_settled = was_placed && angle <= last_angle && angle > kSettled * last_angle;
    if (is_placed && (angle <= options.tolerance || (angle <= options.lean && has_settled)))
      return true;
    if (iteration == options.max_iterations || !error.allFinite()) return false;
    const bool is_near = options.lean > 0 && distance <= kPlaced && angle <= 2 * options.lean;
    step(error, is_near ? kTurnWeight : 1, pull, q);
    was_placed = is_placed;
    last_angle = angle;
  }
}

void DampedLeastSquares::step(Vector6d error, double weight, bool pull, Eigen::VectorXd& q) {
  const auto n = static_cast<Eigen::Index>(group_.size());
  robot_.jacobian(frame_, X_WL_, J_all_);
  J_.resize(6, n);
  wish_.setZero(n);
  const double gain = pull && n > 6 ? kPull * std::min(1.0, error.norm()) : 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const int joint = group_[i];
    J_.col(i) = J_all_.col(joint);
    wish_[i] = gain * (0.5 * (robot_.lower()[joint] + robot_.upper()[joint]) - q[joint]);
  }
  J_.bottomRows<3>() *= weight;
  error.tail<3>() *= weight;
  // Each round holds at least one more joint, so this ends.
  for (Eigen::Index round = 0; round <= n; ++round) {
    solve_free_joints(error, wish_);
    if (!hold_at_limits(q)) break;
  }
  const double largest = dq_.cwiseAbs().maxCoeff();
  if (largest > kMaxStep) dq_ *= kMaxStep / largest;
  for (Eigen::Index i = 0; i < n; ++i) {
    const int joint = group_[i];
    q[joint] = std::clamp(q[joint] + dq_[i], robot_.lower()[joint], robot_.upper()[joint]);
  }
}

/// dq = wish + J^+ (error - J wish), with J^+ the damped inverse.
void DampedLeastSquares::solve_free_joints(const Vector6d& error, const Eigen::VectorXd& wish) {
  Eigen::Matrix<double, 6, 6> A = J_.lazyProduct(J_.transpose());
  A.diagonal().array() += kDamping * error.squaredNorm() + kLeastDamping;
  const Vector6d rest = error - J_.lazyProduct(wish);
  dq_.noalias() = J_.transpose() * Vector6d(A.ldlt().solve(rest));
  dq_ += wish;
}

/// Removes the joints from the problem that are at a limit and would leave it; true if there were
/// any.
bool DampedLeastSquares::hold_at_limits(const Eigen::VectorXd& q) {
  bool any = false;
  for (Eigen::Index i = 0; i < dq_.size(); ++i) {
    const int joint = group_[i];
    const bool pushes = (dq_[i] < 0 && q[joint] <= robot_.lower()[joint]) ||
                        (dq_[i] > 0 && q[joint] >= robot_.upper()[joint]);
    if (!pushes) continue;
    J_.col(i).setZero();
    wish_[i] = 0;
    any = true;
  }
  return any;
}

}  // namespace graspless::robot
