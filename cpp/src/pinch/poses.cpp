// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pinch/poses.hpp"

#include <algorithm>
#include <cmath>

#include "pinch/walls.hpp"

namespace graspless::pinch {

using Eigen::AngleAxisd, Eigen::Isometry3d, Eigen::Vector2d, Eigen::Vector3d;

namespace {

constexpr double kTilts[] = {0, M_PI / 6, -M_PI / 6, M_PI / 3, -M_PI / 3, M_PI / 2, -M_PI / 2};
constexpr double kUprightTilt = 0.3;   // cost of an approach along the support
constexpr double kSameHeight = 0.008;  // [m]
constexpr double kSpare = 0.002;  // of the fingers over `clearance`, if a prism is high enough [m]
constexpr double kTighter = 0.001, kLooser = 0.0035;  // than the faces are apart: closed hands [m]

/// Rotation of the hand, in S: Z_H down and tilted about Y_H, Y_H along the closing direction or
/// against it.
Eigen::Matrix3d rotation(const Vector2d& closing_S, int roll, double tilt) {
  const Vector3d y = (roll == 0 ? 1 : -1) * Vector3d(closing_S.x(), closing_S.y(), 0);
  const Vector3d z = AngleAxisd(tilt, y) * Vector3d(-Vector3d::UnitZ());
  Eigen::Matrix3d R;
  R << y.cross(z), y, z;
  return R;
}

/// Heights of the contacts between two bounds: that of the faces, if they have one, or else the
/// best one, clamped, and higher ones.
std::vector<double> heights(const Faces& faces, double best, double least, double most) {
  if (faces.height) {
    return *faces.height < least ? std::vector<double>{} : std::vector<double>{*faces.height};
  }
  const double middle = std::clamp(best, least, most);
  std::vector<double> found{middle};
  for (const double height : {(middle + most) / 2, most}) {
    if (height > found.back() + kSameHeight) found.push_back(height);
  }
  return found;
}

}  // namespace

Poses::Poses(const Problem& problem, const Options& options, const Jaw& jaw)
    : problem_(problem),
      options_(options),
      jaw_(jaw),
      has_walls_(problem.object.heights()),
      most_(problem.object.thickness() - above()),
      best_(options.height.value_or(problem.object.thickness() / 2)),
      X_SO_(problem.support.X_WS().inverse() * problem.X_WO_start) {
  if (has_walls_) return;  // these bear the object
  press_.emplace(problem, options, jaw);
  if (!press_->unknown().empty()) press_.reset();
}

void Poses::add(const Faces& pair) {
  const std::optional<Grip> grip = jaw_.at_width(pair.width);
  if (!grip) return;
  std::vector<Grip> closed{*grip};
  for (const double width : {pair.width - kTighter, pair.width + kLooser})
    if (const auto other = jaw_.at_width(width)) closed.push_back(*other);
  const std::vector<Shapes> fingers = jaw_.fingers(closed);
  const Vector2d closing_S =
      (X_SO_.linear() * Vector3d(std::cos(pair.yaw), std::sin(pair.yaw), 0)).head<2>();
  for (const double tilt : kTilts) {
    for (const int roll : {0, 1})
      add(pair, *grip, fingers, rotation(closing_S.normalized(), roll, tilt), tilt);
  }
}

void Poses::add(Faces pair, const Grip& grip, const std::vector<Shapes>& fingers,
                const Eigen::Matrix3d& R_SH, double tilt) {
  const Vector3d down_H = -R_SH.row(2).transpose();
  const double below = extent(fingers, down_H) - down_H.dot(grip.contact_H),
               least = options_.clearance + below;
  lowest_ = std::min(lowest_, least);
  if (least > most_) return;
  const double spare = pair.height || options_.height ? 0 : kSpare;
  const Vector3d p_S = X_SO_ * Vector3d(pair.middle().x(), pair.middle().y(), 0);
  for (const double height : heights(pair, best_, std::min(least + spare, most_), most_)) {
    if (!is_borne(pair, height, std::min(below, grip.end))) continue;
    Isometry3d X_SH = Isometry3d::Identity();
    X_SH.linear() = R_SH;
    X_SH.translation() = Vector3d(p_S.x(), p_S.y(), height) - R_SH * grip.contact_H;
    const double off = has_walls_ ? 0 : std::abs(height - best_) / kLever;
    all_.push_back({pair, height, tilt, problem_.support.X_WS() * X_SH,
                    jaw_.shift(grip, pair.width, options_.margin),
                    cost(pair) + kUprightTilt * std::abs(tilt) / (M_PI / 2) + off});
  }
}

/// True if pads that reach `below` their contacts bear a prism, or if nobody knows. Writes what
/// they bear.
bool Poses::is_borne(Faces& pair, double height, double below) {
  if (!press_) return true;
  Faces at = weighed(pair, problem_, height);
  const double aside = std::min(at.offset, pair.width / 2);  // both contacts bear between them
  at.offset -= aside;
  const double half =
      std::min({options_.patch, below, height, problem_.object.thickness() - height});
  pair.max_mass = at.max_mass = largest_mass(
      at, {problem_.hand.pad_friction, press_->at(pair.width), half, 0.5 + aside / pair.width});
  if (*at.max_mass >= problem_.object.mass()) return true;
  if (!heavy_ || *heavy_->max_mass < *at.max_mass) heavy_ = at;
  return false;
}

void Poses::finish(Grasps& result) {
  result.all = std::move(all_);
  std::stable_sort(result.all.begin(), result.all.end(),
                   [](const Grasp& a, const Grasp& b) { return a.cost < b.cost; });
  if (!result.all.empty() || result.status != Status::solved) return;
  if (heavy_) {
    result.status = Status::too_heavy;
    result.reason = too_heavy("faces that are", heavy_->lever, *heavy_, press_->at(heavy_->width),
                              problem_.object.mass());
    return;
  }
  result.status = Status::too_flat;
  const auto tenths = [](double length) { return text_of("%.1f mm", 1000 * length); };
  result.reason = tenths(problem_.object.thickness()) + " high; the fingers touch its faces " +
                  tenths(lowest_) + " or more over the support, which takes a height of " +
                  tenths(lowest_ + above());
}

}  // namespace graspless::pinch
