// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/contact.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::slide {
namespace {

DepthBand model_depths(const Hand& hand) {
  if (hand.finger_model == FingerModel::flexure) return {0.005, 0.025};  // the paper's
  if (hand.finger_model != FingerModel::impedance) return {0, 0};
  const double wanted = hand.press_force / hand.wrist_stiffness;
  return {0.5 * wanted, 1.5 * wanted};
}

}  // namespace

DepthBand depth_band(const Hand& hand, const Options& options) {
  const DepthBand band = model_depths(hand);
  return {options.min_depth.value_or(band.min), options.max_depth.value_or(band.max)};
}

Tip tip(const Eigen::Isometry3d& X_SF) {
  const Eigen::Vector3d x = X_SF.linear().col(0), y = X_SF.linear().col(1),
                        z = X_SF.linear().col(2);
  const Eigen::Vector2d across = x.head<2>().normalized();
  return {X_SF.translation().head<2>(),
          X_SF.translation().z(),
          {across.y(), -across.x()},  // X_F x z
          std::asin(std::clamp(-z.z(), -1.0, 1.0)),
          std::asin(std::clamp(x.z(), -1.0, 1.0)),
          y.z() > 0};
}

Eigen::Isometry3d tip_pose(const Eigen::Vector2d& position, double height, const Eigen::Vector2d& h,
                           double pitch) {
  const double c = std::cos(pitch), s = std::sin(pitch);
  Eigen::Isometry3d X_SF = Eigen::Isometry3d::Identity();
  X_SF.linear().col(0) << -h.y(), h.x(), 0;
  X_SF.linear().col(1) << s * h.x(), s * h.y(), c;
  X_SF.linear().col(2) << c * h.x(), c * h.y(), -s;
  X_SF.translation() << position.x(), position.y(), height;
  return X_SF;
}

double yielded_pitch(const Hand& hand, double depth, double pitch) {
  if (hand.finger_model != FingerModel::flexure) return pitch;
  return std::asin(std::clamp(std::sin(pitch) - depth / hand.flexure_length, -1.0, 1.0));
}

double contact_shift(const Hand& hand, double depth, double pitch, double touch_pitch) {
  if (hand.finger_model != FingerModel::flexure) return 0;
  const double L = hand.flexure_length, r = hand.tip_radius;
  const double flexed = yielded_pitch(hand, depth, pitch);
  return L * (std::cos(flexed) - std::cos(pitch)) + r * (touch_pitch - flexed);
}

Planar effective_tip(const Hand& hand, const Tip& tip, double top, double touch_pitch) {
  const double shift = contact_shift(hand, top - tip.height, tip.pitch, touch_pitch);
  Planar X = Planar::Identity();
  X.linear() << tip.heading.x(), -tip.heading.y(), tip.heading.y(), tip.heading.x();
  X.translation() = tip.position + shift * tip.heading;
  return X;
}

bool is_at_end(const Planar& object_end, const Planar& object_S) {
  const Planar off = object_end.inverse() * object_S;
  return off.translation().norm() <= kEndDistance &&
         std::abs(Eigen::Rotation2Dd(off.rotation()).smallestAngle()) <= kEndTurn;
}

Planar planar(const Eigen::Isometry3d& X) {
  const double yaw = std::atan2(X.linear()(1, 0), X.linear()(0, 0));
  Planar p = Planar::Identity();
  p.linear() = Eigen::Rotation2Dd(yaw).toRotationMatrix();
  p.translation() = X.translation().head<2>();
  return p;
}

Eigen::Isometry3d spatial(const Planar& X) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.linear().topLeftCorner<2, 2>() = X.linear();
  out.translation().head<2>() = X.translation();
  return out;
}

}  // namespace graspless::slide
