// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(), while the finger is on the object.
#include <algorithm>
#include <cmath>

#include "slide/contact.hpp"
#include "slide/examination.hpp"

namespace graspless::slide {
namespace {

constexpr double kRound = 1e-9;
// How far the contact may stray while the finger presses or lifts, and so over a margin that the
// slide just keeps [m].
constexpr double kStray = 5e-4;

}  // namespace

Examination::Finger Examination::finger(const Eigen::VectorXd& q) const {
  const Eigen::Isometry3d X_SF =
      X_SW_ * problem_.robot.pose(problem_.robot.frame(problem_.hand.fingertip), q);
  const Eigen::Matrix3d R = X_SF.linear();
  Finger f;
  f.depth = problem_.object.thickness() - X_SF.translation().z();
  f.pitch = std::atan2(-R(2, 2), R.col(2).head<2>().norm());
  f.roll = std::asin(std::clamp(R(2, 0), -1.0, 1.0));
  f.other_finger_up = R(2, 1) > 0;
  f.commanded = X_SF.translation().head<2>();
  f.heading = Eigen::Vector2d(R(1, 0), -R(0, 0)).normalized();  // across the line contact X_F
  f.effective = f.commanded;
  if (problem_.hand.finger_model == FingerModel::flexure) {
    // The flexure, a length L behind the commanded tip, stays; the finger turns up about it until
    // its tip is in the top face: L sin(pitch') = L sin(pitch) - depth. The pad then rolls by the
    // turn.
    const double L = problem_.hand.flexure_length;
    const double bent = std::asin(std::clamp(std::sin(f.pitch) - f.depth / L, -1.0, 1.0));
    const double ahead = L * std::cos(bent) - L * std::cos(f.pitch);
    const double rolled = problem_.hand.tip_radius * (options_.pitch - bent);
    f.effective += (ahead + rolled) * f.heading;
  }
  return f;
}

/// The object's pose when it follows the effective contact rigidly from the start.
Eigen::Isometry3d Examination::followed(const Finger& start, const Finger& now) const {
  const double turn =
      std::atan2(start.heading.x() * now.heading.y() - start.heading.y() * now.heading.x(),
                 start.heading.dot(now.heading));
  const Eigen::Isometry3d X_SO = X_SW_ * plan_.segments[0].object_poses[0];
  const Eigen::Vector3d from(start.effective.x(), start.effective.y(), 0),
      to(now.effective.x(), now.effective.y(), 0);
  return problem_.support.X_WS() * Eigen::Translation3d(to) *
         Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(-from) * X_SO;
}

/// While the finger presses or lifts, the object must stand still: the effective contact does.
void Examination::check_pressing(const Segment& segment) {
  constexpr double kTurn = 1e-3;  // [rad]
  const bool press = segment.name == "press";
  const Finger pressed = finger(press ? segment.positions.back() : segment.positions.front());
  scene::replay_rows(segment.positions, [&](std::size_t row, const Eigen::VectorXd& q) {
    const Finger now = finger(q);
    if (now.depth > options_.max_depth + kHeightTolerance) {
      fault(segment, row, "pressed " + figure(now.depth) + " m deep");
    }
    if (now.depth <= 0) return;
    const double moved = (now.effective - pressed.effective).norm();
    if (!(moved <= kStray)) fault(segment, row, "the contact moves by " + figure(moved) + " m");
    const double turned = (now.heading - pressed.heading).norm();
    if (!(turned <= kTurn)) fault(segment, row, "the contact turns by " + figure(turned) + " rad");
    check_touching_row(segment, row, now);
  });
}

/// The approach comes from, and the lift goes, clear of the object.
void Examination::check_clearance() {
  for (const auto& q : {segment("press").positions.front(), segment("lift").positions.back()}) {
    const double clear = -finger(q).depth;
    if (clear < options_.lift_height - 1e-4) {
      fault("press or lift", "the fingertip is only " + figure(clear) + " m above the object");
    }
  }
}

/// options.rim_margin, or what a small object has room for.
double Examination::rim_margin() const {
  double farthest = 0;
  const Eigen::Matrix2Xd& outline = problem_.object.outline().vertices();
  for (const auto& p_OP : problem_.object.points().colwise()) {
    farthest = std::max(farthest, inside_by(outline, p_OP));
  }
  return std::min(options_.rim_margin, farthest / 2);
}

void Examination::check_slide() {
  const Segment& slide = segment("slide");
  const Finger start = finger(slide.positions.front());
  const Eigen::Isometry3d X_OS = (X_SW_ * slide.object_poses.front()).inverse();
  const Eigen::Vector3d contact_O =
      X_OS * Eigen::Vector3d(start.effective.x(), start.effective.y(), 0);
  const double inside = inside_by(problem_.object.outline().vertices(), contact_O.head<2>());
  if (inside < -0.001)
    fault(slide, 0, "the contact is not on the object");
  else if (inside < rim_margin() - 0.001) {
    fault(slide, 0, "the contact is " + figure(inside) + " m from the object's rim");
  }
  const double end_pitch = finger(slide.positions.back()).pitch;
  for (const double pitch :
       {start.pitch, end_pitch}) {  // Eqs. (3) and (4): beta = beta_0 at both ends
    if (!(std::abs(pitch - options_.pitch) <= 1e-4)) {
      fault(slide, 0, "begins or ends at pitch " + figure(pitch) + " rad");
    }
  }
  scene::replay_rows(slide.positions, [&](std::size_t row, const Eigen::VectorXd& q) {
    check_slide_row(slide, row, q);
  });
  for (std::size_t row = 0; row < slide.positions.size(); ++row) {
    if (!is_same(followed(start, finger(slide.positions[row])), slide.object_poses[row], kSame)) {
      fault(slide, row, "the object does not follow the contact");
    }
  }
}

void Examination::check_slide_row(const Segment& slide, std::size_t row, const Eigen::VectorXd& q) {
  const Finger now = finger(q);
  const double play = kHeightTolerance + kRound;
  if (!(now.depth >= options_.min_depth - play && now.depth <= options_.max_depth + play)) {
    fault(slide, row, "depth " + figure(now.depth) + " m is out of its band");
  }
  check_touching_row(slide, row, now);
  const Eigen::Matrix2Xd& Q = problem_.support.polygon().vertices();
  if (inside_by(Q, now.commanded) < -kRound ||
      inside_by(Q, now.effective) < options_.tip_margin - kRound) {
    fault(slide, row, "the fingertip or its contact is not far enough inside the support");
  }
}

/// What holds whenever the finger touches the object.
void Examination::check_touching_row(const Segment& segment, std::size_t row, const Finger& now) {
  if (!(std::abs(now.pitch - options_.pitch) <= options_.pitch_tolerance + kRound)) {
    fault(segment, row, "pitch " + figure(now.pitch) + " rad is out of its band");
  }
  if (!(std::abs(now.roll) <= kRollTolerance + kRound)) {
    fault(segment, row, "roll " + figure(now.roll) + " rad");
  }
  if (!now.other_finger_up) fault(segment, row, "the other finger points down");
  const Eigen::Matrix2Xd& Q = problem_.support.polygon().vertices();
  if (inside_by(Q, now.commanded) < -kStray)
    fault(segment, row, "the fingertip leaves the support");
  if (inside_by(Q, now.effective) < options_.tip_margin - kStray) {
    fault(segment, row, "the contact comes too near the edge");
  }
}

}  // namespace graspless::slide
