// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Let e_i be the rotation by q_i about axis i, in P at q = 0. Then g = X_P7 X_P7(0)^-1 = e1 ... e7.
//   e5 e6 e7 do not move the wrist w, e1 e2 e3 do not move the shoulder s, so
//     |e4 w - s| = |g w - s|                                      gives q4;
//     e1 e2 (e3 e4 w - s) = g w - s                               gives q1, q2;
//     e5 e6 a7 = (e1 e2 e3 e4)^-1 g a7,  a7 the seventh axis,     gives q5, q6;
//     e7 b = (e1 ... e6)^-1 g b,  b any vector across a7,         gives q7.
// Cosines and sines are taken from the geometry, not from the angles: arctangents already take most
// of the time.
#include "robot/closed_form.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kMeet = 1e-9;      // axes this close meet [m]
constexpr double kParallel = 1e-6;  // sine of the angle between axes that count as parallel
constexpr double kClamp = 1e-13;    // excess over the reach that counts as rounding (unit vectors)
constexpr double kNoAngle = 1e-28;  // squared length below which a vector has no direction

Vector3d across(const Vector3d& axis, const Vector3d& v) { return v - axis * axis.dot(v); }

double distance(const Vector3d& point, const Screw& screw) {
  return screw.axis.cross(point - screw.point).norm();
}

/// The point nearest to three lines that are not all parallel.
Vector3d meeting_point(const Screw& a, const Screw& b, const Screw& c) {
  Matrix3d A = Matrix3d::Zero();
  Vector3d y = Vector3d::Zero();
  for (const Screw* screw : {&a, &b, &c}) {
    const Matrix3d N = Matrix3d::Identity() - screw->axis * screw->axis.transpose();
    A += N;
    y += N * screw->point;
  }
  return A.inverse() * y;
}

bool meet(const Vector3d& point, const Screw& a, const Screw& b, const Screw& c) {
  return distance(point, a) < kMeet && distance(point, b) < kMeet && distance(point, c) < kMeet;
}

bool parallel(const Screw& a, const Screw& b) { return a.axis.cross(b.axis).norm() < kParallel; }

}  // namespace

/// A rotation about a known axis.
struct ClosedForm::Turn {
  double angle, c, s;
  double slack = 0;  // change of the angle whose effect is within rounding

  static Turn by(double angle) { return {angle, std::cos(angle), std::sin(angle), 0}; }

  /// Subproblem 1: the rotation about `axis` that takes u to v; by `free` if they lie on the axis.
  static Turn from_to(const Vector3d& axis, const Vector3d& u, const Vector3d& v, double free) {
    // Projected first: near the axis, a difference of dot products would lose all digits.
    const Vector3d u_across = across(axis, u), v_across = across(axis, v);
    const double c = u_across.dot(v_across), s = axis.dot(u_across.cross(v_across));
    const double square = c * c + s * s;
    if (!(square > kNoAngle * kNoAngle)) return by(free);
    const double length2 = std::sqrt(square);
    return {std::atan2(s, c), c / length2, s / length2, kClamp / std::sqrt(length2)};
  }

  Vector3d apply(const Vector3d& axis, const Vector3d& v) const {
    return c * v + s * axis.cross(v) + (1 - c) * axis.dot(v) * axis;
  }
  Vector3d undo(const Vector3d& axis, const Vector3d& v) const {
    return c * v - s * axis.cross(v) + (1 - c) * axis.dot(v) * axis;
  }
};

ClosedForm::Elbow ClosedForm::Elbow::of(const Screw& screw, const Vector3d& shoulder,
                                        const Vector3d& wrist) {
  Elbow elbow;
  elbow.p_SE = screw.point - shoulder;
  elbow.p_EW = wrist - screw.point;
  const Turn nearest = Turn::from_to(screw.axis, elbow.p_EW, -elbow.p_SE, 0);
  elbow.angle = nearest.angle;
  elbow.c = nearest.c;
  elbow.s = nearest.s;
  elbow.sum = elbow.p_EW.squaredNorm() + elbow.p_SE.squaredNorm() +
              2 * screw.axis.dot(elbow.p_EW) * screw.axis.dot(elbow.p_SE);
  elbow.product = 2 * across(screw.axis, elbow.p_EW).norm() * across(screw.axis, elbow.p_SE).norm();
  return elbow;
}

/// Subproblem 2: rotations with first(second(u)) = v, for unit vectors u and v. The intermediate
/// vector z = second(u) has v's component along a1 and u's component along a2. Near an axis, the
/// cosine does not tell how far z is from it. So z is built around the axis that it is nearer to,
/// from the length of its component perpendicular to that axis.
struct ClosedForm::TwoTurns {
  TwoTurns(const Vector3d& a1, const Vector3d& a2, const Vector3d& u, const Vector3d& v) {
    const double along1 = a1.dot(v), along2 = a2.dot(u);
    if (std::abs(along1) > std::abs(along2)) {
      build(a1, a2, along1, along2, across(a1, v).squaredNorm());
    } else {
      build(a2, a1, along2, along1, across(a2, u).squaredNorm());
    }
  }

  /// a: the axis that z is built around; b: the other. `square`: squared length of z's component
  /// perpendicular to a.
  void build(const Vector3d& a, const Vector3d& b, double along_a, double along_b, double square) {
    const double cosine = a.dot(b);
    const Vector3d cross = a.cross(b);
    const double sine = cross.norm();
    const double x =
        (along_b - cosine * along_a) / sine;  // of z in the plane of a and b, perpendicular to a
    const double y2 = square - x * x;         // squared component out of that plane
    in_plane = along_a * a + x / sine * (b - cosine * a);
    out_of_plane = std::sqrt(std::max(0.0, y2)) / sine * cross;
    const double slack = kClamp * (std::sqrt(square) + kClamp);
    count = y2 < -slack ? 0 : y2 <= 0 ? 1 : 2;
  }

  Vector3d between(int i) const { return in_plane + (i == 0 ? 1 : -1) * out_of_plane; }

  Vector3d in_plane, out_of_plane;
  int count;
};

/// One call of solve(). q[i] is the angle of joint i + 1.
struct ClosedForm::Search {
  const ClosedForm& arm;
  const Eigen::VectorXd& seed;
  const Wraps& wraps;
  int count;
  Eigen::MatrixXd& solutions;
  Vector3d p_SW;   // unit, from the shoulder to the required wrist position
  double reach;    // its distance [m]
  Vector3d a7, b;  // required directions of axis 7 and of the vector across it
  Turn turn3;
  double q[7];

  double free(int i) const { return seed[wraps.group()[i]]; }

  /// Sets the i-th angle; false if it is outside its limits. Near an axis an angle is known to a
  /// few digits only, so an angle barely outside is moved onto the limit and the following joints
  /// compensate.
  bool set(int i, Turn& turn) {
    q[i] = turn.angle;
    if (wraps.fits(i, q[i])) return true;
    if (!wraps.nudge(i, turn.slack, q[i])) return false;
    turn = Turn::by(q[i]);
    return true;
  }

  /// Subproblem 3: turns of the wrist about axis 4 to the right distance from the shoulder.
  void elbow() {
    const Elbow& elbow = arm.elbow_;
    const double cosine = (elbow.sum - reach * reach) / elbow.product;
    if (!(std::abs(cosine) <= 1 + kClamp)) return;
    const double c = std::clamp(cosine, -1.0, 1.0), s = std::sqrt((1 - c) * (1 + c));
    const double angle = std::atan2(s, c);
    for (const int sign : {1, -1}) {
      if (sign < 0 && s == 0) break;
      Turn turn{elbow.angle + sign * angle, elbow.c * c - elbow.s * sign * s,
                elbow.s * c + elbow.c * sign * s, 0};
      if (set(3, turn)) shoulder(turn);
    }
  }

  void shoulder(const Turn& turn4) {
    const Vector3d p_SW4 = arm.elbow_.p_SE + turn4.apply(arm.axis_[3], arm.elbow_.p_EW);
    const Vector3d u = turn3.apply(arm.axis_[2], p_SW4) / reach;
    const TwoTurns turns(arm.axis_[0], arm.axis_[1], u, p_SW);
    for (int i = 0; i < turns.count; ++i) {
      const Vector3d z = turns.between(i);
      Turn turn2 = Turn::from_to(arm.axis_[1], u, z, free(1));
      if (!set(1, turn2)) continue;
      Turn turn1 = Turn::from_to(arm.axis_[0], z, p_SW, free(0));
      if (!set(0, turn1)) continue;
      const auto back = [&](const Vector3d& v) {
        const Vector3d v2 = turn2.undo(arm.axis_[1], turn1.undo(arm.axis_[0], v));
        return turn4.undo(arm.axis_[3], turn3.undo(arm.axis_[2], v2));
      };
      wrist(back(a7), back(b));
    }
  }

  void wrist(const Vector3d& a7_needed, const Vector3d& b_needed) {
    const TwoTurns turns(arm.axis_[4], arm.axis_[5], arm.axis_[6], a7_needed);
    for (int i = 0; i < turns.count; ++i) {
      const Vector3d z = turns.between(i);
      Turn turn6 = Turn::from_to(arm.axis_[5], arm.axis_[6], z, free(5));
      if (!set(5, turn6)) continue;
      Turn turn5 = Turn::from_to(arm.axis_[4], z, a7_needed, free(4));
      if (!set(4, turn5)) continue;
      const Vector3d b6 = turn6.undo(arm.axis_[5], turn5.undo(arm.axis_[4], b_needed));
      Turn turn7 = Turn::from_to(arm.axis_[6], arm.across_, b6, free(6));
      if (set(6, turn7)) count = wraps.append(q, seed, count, solutions);
    }
  }
};

std::optional<ClosedForm> ClosedForm::detect(const std::array<Screw, 7>& screws,
                                             const Eigen::Isometry3d& X_P7) {
  const auto& s = screws;
  if (parallel(s[0], s[1]) || parallel(s[4], s[5]) || parallel(s[5], s[6])) return {};
  ClosedForm arm;
  arm.shoulder_ = meeting_point(s[0], s[1], s[2]);
  arm.wrist_ = meeting_point(s[4], s[5], s[6]);
  if (!meet(arm.shoulder_, s[0], s[1], s[2]) || !meet(arm.wrist_, s[4], s[5], s[6])) return {};
  // Otherwise axis 4 does not change the distance between shoulder and wrist.
  if (distance(arm.shoulder_, s[3]) < kParallel || distance(arm.wrist_, s[3]) < kParallel)
    return {};
  for (std::size_t i = 0; i < 7; ++i) arm.axis_[i] = s[i].axis;
  arm.elbow_ = Elbow::of(s[3], arm.shoulder_, arm.wrist_);
  arm.R_7P_ = X_P7.linear().transpose();
  arm.p_7W_ = X_P7.inverse() * arm.wrist_;
  arm.across_ = s[6].axis.unitOrthogonal();
  return arm;
}

int ClosedForm::solve(const Eigen::Isometry3d& X_P7, double q3, const Eigen::VectorXd& q,
                      const Wraps& wraps, int count, Eigen::MatrixXd& solutions) const {
  const Vector3d p_SW = X_P7 * p_7W_ - shoulder_;
  const double reach = p_SW.norm();
  if (!(reach > kMeet) || !std::isfinite(reach) || !wraps.fits(2, q3)) return count;
  const Matrix3d R = X_P7.linear() * R_7P_;
  Search search{*this,        q,           wraps,        count, solutions, p_SW / reach, reach,
                R * axis_[6], R * across_, Turn::by(q3), {}};
  search.q[2] = q3;
  search.elbow();
  return search.count;
}

}  // namespace graspless::robot
