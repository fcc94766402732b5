// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Task-space projections: eqs. (2) to (4) of Stork 2013 with their Jacobians.
#include "clasp/search/task_space.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace graspless::clasp {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Distance to the target below which its direction is undefined [m].
constexpr double kOnTarget = 1e-9;

}  // namespace

TaskSpace::TaskSpace(const robot::Robot& robot, const Hand& hand, const Eigen::Matrix3Xd& p_WLoop,
                     std::vector<geometry::ClaspTarget> targets_W)
    : kinematics_(robot, hand), loop_W_(p_WLoop), targets_W_(std::move(targets_W)) {
  if (targets_W_.empty()) throw std::invalid_argument("targets must not be empty");
  curves_.resize(kinematics_.num_curves());
  for (int i = 0; i < kinematics_.num_curves(); ++i) {
    curves_[i].points = kinematics_.curve_points(i);
  }
  linking_.setZero(kinematics_.num_curves());
  project(robot.clamp(Eigen::VectorXd::Zero(robot.dof())));
}

const TaskPoint& TaskSpace::project(const Eigen::VectorXd& q) {
  if (q_.size() == q.size() && q_ == q) return x_;
  kinematics_.update(q);
  q_ = q;
  find_center();
  find_target();
  for (int i = 0; i < kinematics_.num_curves(); ++i) {
    Curve& curve = curves_[i];
    link(curve, kinematics_.curve(i));
    linking_[i] = std::min(1.0, std::abs(curve.linking_number) * curve.closedness);
  }
  x_[3] = linking_.mean();  // (4)
  return x_;
}

void TaskSpace::find_center() {
  const Eigen::Matrix3Xd& p_WN = kinematics_.nodes();
  lowest_.setZero();
  highest_.setZero();
  for (int n = 1; n < p_WN.cols(); ++n) {
    for (int k = 0; k < 3; ++k) {
      if (p_WN(k, n) < p_WN(k, lowest_[k])) lowest_[k] = n;
      if (p_WN(k, n) > p_WN(k, highest_[k])) highest_[k] = n;
    }
  }
  for (int k = 0; k < 3; ++k) x_[k] = (p_WN(k, lowest_[k]) + p_WN(k, highest_[k])) / 2;
}

void TaskSpace::find_target() {
  const Vector3d center = position();
  double least = (targets_W_[0].point - center).squaredNorm();
  nearest_ = 0;
  for (std::size_t i = 1; i < targets_W_.size(); ++i) {
    const double square = (targets_W_[i].point - center).squaredNorm();
    if (square >= least) continue;
    least = square;
    nearest_ = static_cast<int>(i);
  }
  distance_ = std::sqrt(least);
  towards_.setZero();
  if (distance_ < kOnTarget) return;
  towards_ = (targets_W_[nearest_].point - center) / distance_;
}

/// Eq. (2), with Lk as an integer.
void TaskSpace::link(Curve& curve, const std::vector<int>& corners) {
  const Eigen::Matrix3Xd& p_WN = kinematics_.nodes();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    curve.points.col(k) = p_WN.col(corners[k]);
  }
  curve.linking_number = loop_W_.linking_number(curve.points);
  if (curve.linking_number != 0) {
    curve.closedness = geometry::closedness(curve.points, curve.gradient);
  }
}

Vector2d TaskSpace::alignment() const {
  const Vector3d& tangent = targets_W_[nearest_].tangent;
  const double forward = distance_ < kOnTarget ? 1 : kinematics_.forward_W().dot(towards_);
  return {std::abs(kinematics_.sideways_W().dot(tangent)), forward};  // (3)
}

void TaskSpace::position_jacobian(Matrix& J) const {
  J.setZero(3, q_.size());
  for (int k = 0; k < 3; ++k) {
    kinematics_.add_row(lowest_[k], 0.5 * Vector3d::Unit(k), J.row(k));
    kinematics_.add_row(highest_[k], 0.5 * Vector3d::Unit(k), J.row(k));
  }
}

void TaskSpace::alignment_jacobian(Matrix& J) const {
  J.setZero(2, q_.size());
  const Vector3d& tangent = targets_W_[nearest_].tangent;
  const Vector3d sideways = kinematics_.sideways_W(), forward = kinematics_.forward_W();
  const double sign = sideways.dot(tangent) < 0 ? -1 : 1;
  kinematics_.add_rotation_row(sign * sideways.cross(tangent), J.row(0));
  if (distance_ < kOnTarget) return;
  kinematics_.add_rotation_row(forward.cross(towards_), J.row(1));
  // The direction to the target changes when the centre moves across it.
  const Vector3d by_center = (forward.dot(towards_) * towards_ - forward) / distance_;
  for (int k = 0; k < 3; ++k) {
    const Vector3d half = 0.5 * by_center[k] * Vector3d::Unit(k);
    kinematics_.add_row(lowest_[k], half, J.row(1));
    kinematics_.add_row(highest_[k], half, J.row(1));
  }
}

void TaskSpace::linking_jacobian(Matrix& J) const {
  J.setZero(kinematics_.num_curves(), q_.size());
  for (int i = 0; i < kinematics_.num_curves(); ++i) {
    const Curve& curve = curves_[i];
    const double factor = std::abs(curve.linking_number);
    if (factor == 0 || factor * curve.closedness >= 1) continue;
    const std::vector<int>& corners = kinematics_.curve(i);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vector3d gradient = factor * curve.gradient.col(k);
      kinematics_.add_row(corners[k], gradient, J.row(i));
    }
  }
}

/// The field of the loop has no curl, so the integral changes with the curve's ends only.
void TaskSpace::attract(Eigen::VectorXd& u, Matrix& J) const {
  for (int i = 0; i < kinematics_.num_curves(); ++i) {
    const Curve& curve = curves_[i];
    if (curve.linking_number != 0) continue;
    const double integral = loop_W_.gauss_linking(curve.points, false);
    const double sign = integral < 0 ? -1 : 1;
    u[i] = 1 - std::min(1.0, std::abs(integral));
    J.row(i).setZero();
    const int first = kinematics_.curve(i).front(), last = kinematics_.curve(i).back();
    kinematics_.add_row(last, sign * loop_W_.field(kinematics_.nodes().col(last)), J.row(i));
    kinematics_.add_row(first, -sign * loop_W_.field(kinematics_.nodes().col(first)), J.row(i));
  }
}

}  // namespace graspless::clasp
