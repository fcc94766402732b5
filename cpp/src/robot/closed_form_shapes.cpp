// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Recognizes the shape of an arm by its axes.
#include <algorithm>

#include "robot/closed_form.hpp"

namespace graspless::robot {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kExact = 1e-10;  // deviation of axes whose solutions need no polish [m, rad]
constexpr double kNear = 0.01;    // largest deviation from a shape [m, rad]
constexpr double kBetter = 0.2;   // a later shape must fit this much better
constexpr double kMargin = 1e-3;  // least sine and distance of axes that must differ [rad, m]
constexpr double kShare = 0.05;   // largest deviation, as a share of these

double distance(const Vector3d& point, const Screw& screw) {
  return screw.axis.cross(point - screw.point).norm();
}

/// The point nearest to lines that are not all parallel.
Vector3d meeting_point(std::initializer_list<const Screw*> screws) {
  Matrix3d A = Matrix3d::Zero();
  Vector3d y = Vector3d::Zero();
  for (const Screw* screw : screws) {
    const Matrix3d N = Matrix3d::Identity() - screw->axis * screw->axis.transpose();
    A += N;
    y += N * screw->point;
  }
  return A.inverse() * y;
}

Vector3d nearest(const Screw& screw, const Vector3d& point) {
  return screw.point + screw.axis * screw.axis.dot(point - screw.point);
}

}  // namespace

ClosedForm::ClosedForm(const std::vector<Screw>& screws, const Isometry3d& X_PE, Shape shape,
                       Free free, bool reversed)
    : shape_(shape), free_(free), reversed_(reversed) {
  static constexpr int kHeld[] = {-1, 0, 2, 6};  // by Free
  polish_.held = kHeld[static_cast<int>(free)];
  polish_.size = static_cast<int>(screws.size());
  std::copy(screws.begin(), screws.end(), polish_.screws.begin());
  polish_.X_PE_zero = X_PE;
  for (int joint = 0, i = 0; joint < polish_.size; ++joint) {
    if (joint != polish_.held) joint_[reversed ? 5 - i++ : i++] = joint;
  }
  free_axis_ = {Vector3d::UnitZ(), Vector3d::Zero()};
  if (free != Free::none) free_axis_ = screws[polish_.held];
  if (free == Free::last) {
    const Isometry3d X_EP = X_PE.inverse();
    free_axis_ = {X_EP.linear() * free_axis_.axis, X_EP * free_axis_.point};
  }
}

ClosedForm::Axes ClosedForm::ordered() const {
  Axes axes;
  for (std::size_t i = 0; i < 6; ++i) {
    axes[i] = polish_.screws[joint_[i]];
    if (reversed_) axes[i].axis *= -1;  // the inverse of e1 ... e6 is a product of inverse turns
  }
  return axes;
}

/// Finds the point nearest to the axes, and adds their distance from it to the deviation.
bool ClosedForm::meet(std::initializer_list<const Screw*> axes, Vector3d& point) {
  point = meeting_point(axes);
  for (const Screw* screw : axes) deviation_ = std::max(deviation_, distance(point, *screw));
  return deviation_ <= kNear;
}

/// Makes axes 2 to `last` parallel, and takes points on them near the wrist.
bool ClosedForm::make_parallel(int last, Axes& axes) {
  Vector3d h = axes[1].axis;
  for (int i = 2; i <= last; ++i) h += axes[i].axis.dot(h) > 0 ? axes[i].axis : -axes[i].axis;
  h.normalize();
  for (int i = 1; i <= last; ++i) {
    deviation_ = std::max(deviation_, h.cross(axes[i].axis).norm());
    axes[i] = {axes[i].axis.dot(h) > 0 ? h : -h, nearest(axes[i], wrist_)};
  }
  return deviation_ <= kNear;
}

/// Fits the shape to the axes of six joints; false if they are too far from it, or if the
/// subproblems have no unique solution: for parallel axes where a subproblem needs two directions,
/// and for an axis 3 that does not change the distance from the shoulder.
bool ClosedForm::fit(Axes axes) {
  const auto& [a1, a2, a3, a4, a5, a6] = axes;
  const bool three = shape_ == Shape::three_parallel;
  const auto sine = [](const Screw& a, const Screw& b) { return a.axis.cross(b.axis).norm(); };
  if (std::min({sine(a1, a2), sine(a4, a5), sine(a5, a6)}) < kMargin) return false;
  if (!(three ? meet({&a5, &a6}, wrist_) : meet({&a4, &a5, &a6}, wrist_))) return false;
  if (shape_ != Shape::shoulder_meets) {
    if (!make_parallel(three ? 3 : 2, axes)) return false;
    shoulder_ = a2.point;
  } else if (!(free_ == Free::third ? meet({&a1, &a2, &free_axis_}, shoulder_)
                                    : meet({&a1, &a2}, shoulder_))) {
    return false;
  }
  const Vector3d moved = three ? a4.point : wrist_;
  const double margin = std::min(
      {sine(a1, a2), sine(a4, a5), sine(a5, a6), distance(shoulder_, a3), distance(moved, a3)});
  if (margin < kMargin || deviation_ > kShare * margin) return false;
  for (std::size_t i = 0; i < 6; ++i) axis_[i] = axes[i].axis;
  base_ = a1.point;
  p_W4_ = a4.point - wrist_;
  elbow_ = Elbow::of(a3, shoulder_, moved);
  R_EP_ = polish_.X_PE_zero.linear().transpose();
  p_EW_ = polish_.X_PE_zero.inverse() * wrist_;
  across_ = a6.axis.unitOrthogonal();
  if (deviation_ > kExact) slack_ = std::clamp(20 * deviation_, kClose, 0.1);
  return true;
}

std::optional<ClosedForm> ClosedForm::detect(const std::vector<Screw>& screws,
                                             const Isometry3d& X_PE) {
  std::optional<ClosedForm> best;
  const auto consider = [&](Shape shape, Free free, bool reversed) {
    if (best && best->deviation_ <= kExact) return;
    ClosedForm arm(screws, X_PE, shape, free, reversed);
    if (arm.fit(arm.ordered()) && (!best || arm.deviation_ < kBetter * best->deviation_))
      best = arm;
  };
  if (screws.size() == 7) consider(Shape::shoulder_meets, Free::third, false);
  for (const Free free : {Free::none, Free::last, Free::first}) {
    if (screws.size() != (free == Free::none ? 6 : 7)) continue;
    for (const bool reversed : {false, true}) {
      for (const Shape shape :
           {Shape::shoulder_meets, Shape::elbow_parallel, Shape::three_parallel}) {
        consider(shape, free, reversed);
      }
    }
  }
  return best;
}

}  // namespace graspless::robot
