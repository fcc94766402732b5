// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Part of check(): the segments in which the finger touches the object.
#include "slide/contact.hpp"

#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

#include "slide/check/examination.hpp"
#include "text.hpp"

namespace graspless::slide {

DepthBand allowed_depths(const Hand& hand, const Options& options) {
  DepthBand depths{0, 0};
  if (hand.finger_model == FingerModel::flexure) depths = {0.005, 0.025};
  if (hand.finger_model == FingerModel::impedance) {
    const double spring = hand.press_force / hand.wrist_stiffness;  // its deflection [m]
    depths = {spring / 2, 3 * spring / 2};
  }
  if (options.min_depth) depths.min = *options.min_depth;
  if (options.max_depth) depths.max = *options.max_depth;
  return depths;
}

ReplayedFinger Examination::finger(const Eigen::Isometry3d& X_WF) const {
  const Eigen::Isometry3d X_SF = X_SW_ * X_WF;
  const Eigen::Matrix3d R = X_SF.linear();
  Finger f;
  f.depth = problem_.object.top() - X_SF.translation().z();
  f.pitch = std::atan2(-R(2, 2), R.col(2).head<2>().norm());
  f.roll = std::asin(std::clamp(R(2, 0), -1.0, 1.0));
  f.other_finger_up = R(2, 1);
  f.commanded = X_SF.translation().head<2>();
  f.heading = Eigen::Vector2d(R(1, 0), -R(0, 0)).normalized();  // across the line contact X_F
  f.effective = f.commanded;
  f.bent = f.pitch;
  if (problem_.hand.finger_model == FingerModel::flexure) {
    // The flexure, a length L behind the commanded tip, stays in place. The finger turns up about
    // it until its tip lies in the top face: L sin(pitch') = L sin(pitch) - depth. The pad rolls by
    // the same angle.
    const double L = problem_.hand.flexure_length;
    f.bent = std::asin(std::clamp(std::sin(f.pitch) - f.depth / L, -1.0, 1.0));
    const double ahead = L * std::cos(f.bent) - L * std::cos(f.pitch);
    const double rolled = problem_.hand.tip_radius * (options_.pitch - f.bent);
    f.effective += (ahead + rolled) * f.heading;
  }
  return f;
}

/// The object's pose if it follows the effective contact rigidly from its pose at the start, Eq.
/// (2).
Eigen::Isometry3d Examination::followed(const Eigen::Isometry3d& X_WO_start, const Finger& start,
                                        const Finger& now) const {
  const double turn =
      std::atan2(start.heading.x() * now.heading.y() - start.heading.y() * now.heading.x(),
                 start.heading.dot(now.heading));
  const Eigen::Isometry3d X_SO = X_SW_ * X_WO_start;
  const Eigen::Vector3d from(start.effective.x(), start.effective.y(), 0),
      to(now.effective.x(), now.effective.y(), 0);
  return problem_.support.X_WS() * Eigen::Translation3d(to) *
         Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(-from) * X_SO;
}

/// The object must not move while the finger presses or lifts, so the effective contact must not
/// either.
void Examination::check_pressing(const Segment& segment) {
  const bool press = segment.name == "press";
  // Rigid fingers press at depth 0, where the contact of a flexing one begins to move.
  const bool flexes = problem_.hand.finger_model == FingerModel::flexure;
  const double touching = flexes ? 0 : -kHeightTolerance;
  const Finger pressed = finger(press ? segment.positions.back() : segment.positions.front());
  scene::replay_rows(problem_.robot, segment.positions,
                     [&](std::size_t row, const Eigen::VectorXd& q) {
                       const Finger now = finger(q);
                       check_depth(segment, row, now);
                       if (now.depth <= touching) return;
                       check_still(segment, row, now, pressed);
                       check_touching_row(segment, row, now);
                     });
}

/// A finger that presses on the object must not move it while it retreats. One that has lost it may
/// move.
void Examination::check_retreat(const Segment& segment) {
  const Finger pressed = finger(segment.positions.front());
  const bool on_object = is_on_object(segment, pressed);
  scene::replay_rows(problem_.robot, segment.positions,
                     [&](std::size_t row, const Eigen::VectorXd& q) {
                       const Finger now = finger(q);
                       check_depth(segment, row, now);
                       if (on_object && now.depth > 0) check_still(segment, row, now, pressed);
                     });
}

bool Examination::is_on_object(const Segment& segment, const Finger& pressed) const {
  const Eigen::Isometry3d X_OS = (X_SW_ * segment.object_poses.front()).inverse();
  const Eigen::Vector3d contact_O =
      X_OS * Eigen::Vector3d(pressed.effective.x(), pressed.effective.y(), 0);
  return signed_depth(problem_.object.outline().vertices(), contact_O.head<2>()) > kRound;
}

void Examination::check_depth(const Segment& segment, std::size_t row, const Finger& now) {
  if (now.depth > depths_.max + kHeightTolerance) {
    fault(segment, row, "the fingertip presses " + figure(now.depth) + " m deep");
  }
}

void Examination::check_still(const Segment& segment, std::size_t row, const Finger& now,
                              const Finger& pressed) {
  const double moved = (now.effective - pressed.effective).norm();
  if (!(moved <= kStray)) fault(segment, row, "the contact moves by " + figure(moved) + " m");
  const double turned = (now.heading - pressed.heading).norm();
  if (!(turned <= kStrayTurn))
    fault(segment, row, "the contact turns by " + figure(turned) + " rad");
}

/// The fingertip must be clear of the object where the press begins and where the lift ends.
void Examination::check_clearance() {
  const auto check_clear = [this](const Segment& segment, std::size_t row) {
    const double clear = -finger(segment.positions[row]).depth;
    if (clear < options_.lift_height - 1e-4)
      fault(segment, row, "the fingertip is only " + figure(clear) + " m above the object");
  };
  const Segment& lift = segment("lift");
  check_clear(lift, lift.positions.size() - 1);
  if (has("press")) check_clear(segment("press"), 0);
}

/// options.rim_margin, or less for a small object.
double Examination::rim_margin() const {
  double farthest = 0;
  const Eigen::Matrix2Xd& outline = problem_.object.outline().vertices();
  for (const auto& p_OP : problem_.object.points().colwise()) {
    poll();
    farthest = std::max(farthest, signed_depth(outline, p_OP));
  }
  return std::min(options_.rim_margin, farthest / 2);
}

/// Where the object has heights, the part of the pad that must bear presses on a part of it that is
/// level, and the rest meets nothing.
void Examination::check_face(const Eigen::Vector2d& contact_O) {
  constexpr double kLevel = 0.003, kStep = 0.001, kLeast = 0.006;  // [m]
  const auto& map = problem_.object.heights();
  if (!map) return;
  const double top = problem_.object.top(), reach = problem_.hand.pad_width / 2,
               bearing = std::max(kLeast, (1 - options_.pad_spread) * reach);
  bool is_on_face = false;
  for (const double x : {-kStep, 0.0, kStep}) {
    for (const double y : {-kStep, 0.0, kStep}) {
      const double height = map->at(contact_O + Eigen::Vector2d(x, y));
      is_on_face = is_on_face || (height > 0 && std::abs(height - top) <= kLevel);
    }
  }
  if (!is_on_face) {
    fault("slide", "the object is " + figure(map->at(contact_O)) + " m high at the contact, not " +
                       figure(top) + " m");
    return;
  }
  for (double x = -reach; x <= reach; x += kStep) {
    poll();
    for (double y = -reach; y <= reach; y += kStep) {
      const double height = map->at(contact_O + Eigen::Vector2d(x, y));
      const double away = std::hypot(x, y) + map->cell;
      if (height == 0 || away > (height < top ? bearing : std::max(reach, bearing))) continue;
      if (std::abs(height - top) <= kLevel) continue;
      fault("slide", "the object is " + figure(height) + " m high beside the contact, not " +
                         figure(top) + " m");
      return;
    }
  }
}

void Examination::check_slide() {
  const Segment& slide = segment("slide");
  const Finger start = finger(slide.positions.front());
  const Eigen::Isometry3d X_OS = (X_SW_ * slide.object_poses.front()).inverse();
  const Eigen::Vector3d contact_O =
      X_OS * Eigen::Vector3d(start.effective.x(), start.effective.y(), 0);
  const double inside = signed_depth(problem_.object.outline().vertices(), contact_O.head<2>());
  if (inside < -0.001)
    fault(slide, 0, "the contact is not on the object");
  else if (inside < rim_margin() - 0.001) {
    fault(slide, 0, "the contact is " + figure(inside) + " m from the object's rim");
  }
  check_face(contact_O.head<2>());
  // Eqs. (3) and (4): beta = beta_0 at both ends.
  std::vector<double> pitches{finger(slide.positions.back()).pitch};
  if (has("press")) pitches.push_back(start.pitch);
  for (const double pitch : pitches) {
    if (!(std::abs(pitch - options_.pitch) <= 1e-4)) {
      fault(slide, 0, "begins or ends at pitch " + figure(pitch) + " rad");
    }
  }
  scene::replay_rows(
      problem_.robot, slide.positions,
      [&](std::size_t row, const Eigen::VectorXd& q) { check_slide_row(slide, row, q); });
  for (std::size_t row = 0; row < slide.positions.size(); ++row) {
    poll();
    if (!scene::is_same(followed(slide.object_poses[0], start, finger(slide.positions[row])),
                        slide.object_poses[row], kSame)) {
      fault(slide, row, "the object does not follow the contact");
    }
  }
}

void Examination::check_slide_row(const Segment& slide, std::size_t row, const Eigen::VectorXd& q) {
  const Finger now = finger(q);
  const double play = kHeightTolerance + kRound;
  if (!(now.depth >= depths_.min - play && now.depth <= depths_.max + play)) {
    fault(slide, row,
          "depth " + figure(now.depth) + " m is outside its band, " + figure(depths_.min) + " to " +
              figure(depths_.max) + " m");
  }
  check_touching_row(slide, row, now);
  const Eigen::Matrix2Xd& Q = problem_.support.polygon().vertices();
  if (signed_depth(Q, now.commanded) < -kRound ||
      signed_depth(Q, now.effective) < options_.tip_margin - kRound) {
    fault(slide, row, "the fingertip or its contact is not far enough inside the support");
  }
}

/// Conditions of every row in which the finger touches the object.
void Examination::check_touching_row(const Segment& segment, std::size_t row, const Finger& now) {
  if (!(std::abs(now.pitch - options_.pitch) <= options_.pitch_tolerance + kRound)) {
    fault(segment, row,
          "pitch " + figure(now.pitch) + " rad is outside its band, options.pitch " +
              figure(options_.pitch) + " +- " + figure(options_.pitch_tolerance) + " rad");
  }
  if (!(std::abs(now.roll) <= kRollTolerance + kRound)) {
    fault(segment, row, "roll " + figure(now.roll) + " rad exceeds its tolerance");
  }
  const FingerModel model = problem_.hand.finger_model;
  const bool yields = model == FingerModel::flexure || model == FingerModel::impedance;
  const double sink = profile_.below(now.bent) + (yields ? 0 : now.depth);
  if (!(sink <= allowed_sink(problem_.hand) + kHeightTolerance)) {
    fault(segment, row, "the finger is " + figure(sink) + " m below the object's top face");
  }
  if (!(now.other_finger_up > 0)) fault(segment, row, "the other finger points down");
  const Eigen::Matrix2Xd& Q = problem_.support.polygon().vertices();
  if (signed_depth(Q, now.commanded) < -kStray)
    fault(segment, row, "the fingertip leaves the support");
  if (signed_depth(Q, now.effective) < options_.tip_margin - kStray) {
    fault(segment, row, "the contact comes too near the edge");
  }
}

}  // namespace graspless::slide
