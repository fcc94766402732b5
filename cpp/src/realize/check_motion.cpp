// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check() of a realization: the object on its path, fingertips at their places, nothing touching.
#include <algorithm>
#include <cmath>

#include "realize/examination.hpp"
#include "scene/rows.hpp"
#include "text.hpp"

namespace graspless::realize {
namespace {

constexpr double kSamePose = 1e-6;  // [m, rad]

bool is_same(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return scene::is_same(a, b, kSamePose);
}

/// Part of the screw from X_WA to X_WB at which a pose lies, if it lies on it.
double fraction(const Eigen::Isometry3d& X_WA, const Eigen::Isometry3d& X_WB,
                const Eigen::Isometry3d& X_WO) {
  const Eigen::Isometry3d whole = X_WA.inverse() * X_WB, part = X_WA.inverse() * X_WO;
  const double angle = Eigen::AngleAxisd(whole.linear()).angle();
  if (angle > 1e-6) return Eigen::AngleAxisd(part.linear()).angle() / angle;
  const double length = whole.translation().norm();
  return length > 0 ? part.translation().norm() / length : 0;
}

std::string millimetres(double distance) { return figure(1e3 * distance, 3) + " mm"; }

std::string finger_name(std::size_t finger) { return "finger " + std::to_string(finger); }

constexpr double kWide = 20, kThick = 1;  // of the box that stands for a half-space [m]

/// A box under the plane, in W, its top at the foot of the perpendicular from p_W.
geometry::PlacedShape half_space(const Plane& plane, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d n_W = plane.n_W.normalized();
  const Eigen::Vector3d foot_W = p_W - (n_W.dot(p_W) - plane.offset) * n_W;
  Eigen::Matrix3d R;
  R.col(2) = n_W;
  R.col(0) = n_W.unitOrthogonal();
  R.col(1) = n_W.cross(R.col(0));
  geometry::PlacedShape placed{geometry::Box{{kWide, kWide, kThick}}};
  placed.X_BG.linear() = R;
  placed.X_BG.translation() = foot_W - kThick / 2 * n_W;
  return placed;
}

}  // namespace

Eigen::Isometry3d on_screw(const Eigen::Isometry3d& X_WA, const Eigen::Isometry3d& X_WB, double s) {
  const Eigen::Isometry3d X_AB = X_WA.inverse() * X_WB;
  const Eigen::AngleAxisd turn(X_AB.linear());
  const Eigen::Vector3d u = turn.axis(), p = X_AB.translation();
  Eigen::Isometry3d X_AS = Eigen::Isometry3d::Identity();
  if (turn.angle() < 1e-9) {
    X_AS.translation() = s * p;
    return X_WA * X_AS;
  }
  const double rise = u.dot(p);
  const Eigen::Vector3d across = p - rise * u;
  const Eigen::Vector3d c = (across + u.cross(across) / std::tan(turn.angle() / 2)) / 2;
  X_AS.linear() = Eigen::AngleAxisd(s * turn.angle(), u).toRotationMatrix();
  X_AS.translation() = c - X_AS.linear() * c + s * rise * u;
  return X_WA * X_AS;
}

void Examination::check_object(const JointSegment& segment, const Phase& phase) {
  if (phase.X_WO.size() == 1) return check_still(segment, phase);
  std::size_t arc = 0;  // the rows so far end within it, or at its beginning
  double before = 0;
  for (std::size_t i = 0; i < segment.X_WO.size(); ++i) {
    const double s = fraction(phase.X_WO[arc], phase.X_WO[arc + 1], segment.X_WO[i]);
    const bool on_path =
        s >= before - kSamePose && s <= 1 + kSamePose &&
        is_same(segment.X_WO[i], on_screw(phase.X_WO[arc], phase.X_WO[arc + 1], s));
    if (!on_path || (i == 0 && !is_same(segment.X_WO[i], phase.X_WO[0])))
      return fault(i, "the object is not where the plan's motion continues");
    before = s;
    if (is_same(segment.X_WO[i], phase.X_WO[arc + 1]) && arc + 2 < phase.X_WO.size()) {
      ++arc;
      before = 0;
    }
  }
  if (!is_same(segment.X_WO.back(), phase.X_WO.back()))
    fault(segment.X_WO.size() - 1, "the object does not come to the end of the plan's motion");
}

void Examination::check_still(const JointSegment& segment, const Phase& phase) {
  for (std::size_t i = 0; i < segment.X_WO.size(); ++i) {
    if (!is_same(segment.X_WO[i], phase.X_WO.front()))
      return fault(i, "the object moves, or is not where the plan has it");
  }
}

/// Checks rows and configurations between them, at steps of at most `resolution`. One fault a row
/// is enough.
void Examination::check_segment(const JointSegment& segment, const Phase& phase) {
  check_instant(0, segment.positions[0], segment.X_WO[0], phase);
  for (std::size_t row = 1; row < segment.positions.size(); ++row) {
    const Eigen::VectorXd& from = segment.positions[row - 1];
    const Eigen::VectorXd step = segment.positions[row] - from;
    const double span = step.size() == 0 ? 0 : step.lpNorm<Eigen::Infinity>();
    const int pieces = std::max(2, static_cast<int>(std::ceil(span / options_.resolution - 1e-9)));
    const std::size_t faults = faults_.size();
    for (int i = 1; i <= pieces && faults_.size() == faults; ++i) {
      const double s = static_cast<double>(i) / pieces;
      const auto X_WO = on_screw(segment.X_WO[row - 1], segment.X_WO[row], s);
      check_instant(row, from + s * step, X_WO, phase);
    }
  }
}

void Examination::check_instant(std::size_t row, const Eigen::VectorXd& q,
                                const Eigen::Isometry3d& X_WO, const Phase& phase) {
  robot_.forward(q, X_WL_);
  check_tips(row, X_WO, phase);
  for (const std::string& pair : replay_.touching(X_WL_, X_WO, allowances(phase)))
    fault(row, pair + " touch");
}

/// Links that may reach into the object: those of fingers that hold or move straight on or off.
std::vector<Replay::Allowed> Examination::allowances(const Phase& phase) const {
  const double depth = contact_allowance(options_.position_tolerance);
  std::vector<Replay::Allowed> allowed;
  for (std::size_t i = 0; i < phase.places.size(); ++i) {
    if (!phase.holds[i] && !phase.moves[i]) continue;
    for (const std::string& link : links_of_finger_[i])
      allowed.push_back({link, -phase.places[i].n_O, depth});
  }
  return allowed;
}

/// Checks that fingers that hold are at their places, and that those that move are on the line
/// along the normal.
void Examination::check_tips(std::size_t row, const Eigen::Isometry3d& X_WO, const Phase& phase) {
  const double tolerance = options_.position_tolerance + 1e-9;
  for (std::size_t i = 0; i < phase.places.size(); ++i) {
    const Eigen::Vector3d off_O = tip_O(i, X_WO) - center_O(i, phase);
    const Eigen::Vector3d out_O = -phase.places[i].n_O;
    const double height = off_O.dot(out_O);
    if (phase.holds[i] && off_O.norm() > tolerance)
      fault(row, finger_name(i) + " is " + millimetres(off_O.norm()) + " from its place");
    if (!phase.moves[i]) continue;
    const double aside = (off_O - height * out_O).norm();
    if (aside > tolerance || height < -tolerance || height > options_.approach + tolerance)
      fault(row, finger_name(i) + " does not move along its normal");
  }
}

/// Checks that a finger is at its place when a touch ends and a release begins.
void Examination::check_ends(const JointSegment& segment, const Phase& phase) {
  const std::size_t row = phase.name == "release" ? 0 : segment.positions.size() - 1;
  robot_.forward(segment.positions[row], X_WL_);
  for (std::size_t i = 0; i < phase.places.size(); ++i) {
    if (!phase.moves[i]) continue;
    const double off = (tip_O(i, segment.X_WO[row]) - center_O(i, phase)).norm();
    if (off > options_.position_tolerance + 1e-9)
      fault(row, finger_name(i) + " is " + millimetres(off) + " from its place");
  }
}

/// Checks the scrub: how far the sphere's point on the contact moves, for the worst finger that
/// holds.
void Examination::check_scrub(const JointSegment& segment, const Phase& phase) {
  double worst = 0;
  for (std::size_t i = 0; i < phase.places.size(); ++i) {
    if (!phase.holds[i]) continue;
    const auto frame = static_cast<std::size_t>(frame_of_finger_[i]);
    double path = 0;
    Eigen::Vector3d before_F;
    for (std::size_t row = 0; row < segment.positions.size(); ++row) {
      robot_.forward(segment.positions[row], X_WL_);
      const Eigen::Vector3d n_F =
          X_WL_[frame].linear().transpose() * (segment.X_WO[row].linear() * phase.places[i].n_O);
      if (row > 0) path += (n_F - before_F).norm();
      before_F = n_F;
    }
    worst = std::max(worst, problem_.fingers.radius * path);
  }
  if (std::abs(worst - segment.scrub) > 1e-6 + 0.01 * worst)
    fault(0, "scrub is " + millimetres(segment.scrub) + " but the fingertips slip by " +
                 millimetres(worst));
}

Eigen::Vector3d Examination::tip_O(std::size_t finger, const Eigen::Isometry3d& X_WO) const {
  const auto frame = static_cast<std::size_t>(frame_of_finger_[finger]);
  return X_WO.inverse() * X_WL_[frame].translation();
}

Eigen::Vector3d Examination::center_O(std::size_t finger, const Phase& phase) const {
  return phase.places[finger].p_OC - problem_.fingers.radius * phase.places[finger].n_O;
}

Replay::Replay(const Problem& problem, const robot::Robot& robot) : replay_(robot) {
  for (const Plane& plane : problem.planes) {
    replay_.add({plane.name, {half_space(plane, robot.X_WB().translation())}});
  }
  for (const Obstacle& obstacle : problem.obstacles) replay_.add(obstacle);
  object_ = replay_.add(problem.object.name(), problem.object.solid(), false);
}

std::vector<std::string> Replay::touching(const robot::Poses& X_WL, const Eigen::Isometry3d& X_WO,
                                          const std::vector<Allowed>& allowed) {
  place(X_WO, allowed);
  return replay_.touching(X_WL);
}

void Replay::place(const Eigen::Isometry3d& X_WO, const std::vector<Allowed>& allowed) {
  collision::World& world = replay_.world();
  world.set_pose(object_, X_WO);
  for (int body = 0; body < replay_.num_links(); ++body)
    world.allow_contact(body, object_, Eigen::Vector3d::UnitZ(), 0);
  for (const Allowed& contact : allowed) {
    const int body = replay_.body_of(contact.link);
    if (body >= 0) world.allow_contact(body, object_, X_WO.linear() * contact.out_O, contact.depth);
  }
}

}  // namespace graspless::realize
