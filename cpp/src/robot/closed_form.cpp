// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Let e_i be the rotation by q_i about axis i, in P at q = 0. Then g = X_PE X_PE(0)^-1 = e1 ... e6.
// Let s be a point of axis 2, w the point where the last axes meet, b any vector across the last
// axis a6. The shapes differ in the order of the subproblems:
//
// Axes 1 and 2 meet in s, axes 4 to 6 in w. (e1 and e2 do not move s, e4 to e6 do not move w.)
//   |e3 w - s| = |g w - s|                                gives q3     (subproblem 3);
//   e1 e2 (e3 w - s) = g w - s                            gives q1, q2 (subproblem 2);
//   e4 e5 a6 = (e1 e2 e3)^-1 g a6                         gives q4, q5 (subproblem 2);
//   e6 b = (e1 ... e5)^-1 g b                             gives q6     (subproblem 1).
// A free joint 3 of seven is a known rotation between e2 and e3.
//
// Axes 2 and 3 are parallel to h, axes 4 to 6 meet in w. (e2 and e3 move nothing along h.)
//   h . e1^-1 g w = h . w                                 gives q1     (subproblem 4);
//   |e3 w - s| = |e1^-1 g w - s|                          gives q3     (subproblem 3);
//   e2 (e3 w - s) = e1^-1 g w - s                         gives q2     (subproblem 1);
//   q4, q5, q6 as above.
//
// Axes 2 to 4 are parallel to h, axes 5 and 6 meet in w. Let e be the rotation of e2 e3 e4, and c a
// point of axis 4.
//   h . e1^-1 g w = h . w                                 gives q1     (subproblem 4);
//   e e5 a6 = e1^-1 g a6, e6 b = (e1 e e5)^-1 g b         give e, q5, q6, as q4, q5, q6 above;
//   e2 e3 c = e1^-1 g (e5 e6)^-1 c                        gives q3, q2 (subproblems 3 and 1);
//   e = e2 e3 e4                                          gives q4.
#include "robot/closed_form.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::robot {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kLimit = 0.1;      // polishing may move an angle this far [rad]
constexpr double kRepeated = 1e-6;  // polished solutions this close are one [rad]
constexpr double kFar = 1e6;        // distance out of every arm's reach [m]
constexpr double kMeet = 1e-9;      // distance at which the wrist is in the shoulder [m]

Isometry3d motion(const Screw& screw, double angle) {
  const Isometry3d R(Eigen::AngleAxisd(angle, screw.axis));
  return Eigen::Translation3d(screw.point) * R * Eigen::Translation3d(-screw.point);
}

}  // namespace

/// One call of solve(). q[i] is the angle of joint i of the group.
struct ClosedForm::Search {
  const ClosedForm& arm;
  const Isometry3d& X_PE;
  const Eigen::VectorXd& seed;
  const Wraps& wraps;
  int count;
  Eigen::MatrixXd& solutions;
  Matrix3d R;      // required rotation of the last link of the shape from q = 0
  Vector3d p_PW;   // required position of the wrist
  Vector3d a6, b;  // required directions of axis 6 and of the vector across it
  Turn third;      // of a free joint 3
  double slack;
  bool is_close = false;  // a subproblem without solution nearly had one
  int begin;              // index of the first solution of this call
  double q[7];

  double free(int i) const { return seed[wraps.group()[arm.joint_[i]]]; }

  template <class Solved>
  Solved noted(Solved solved) {
    is_close |= solved.is_close;
    return solved;
  }

  /// Notes an angle that is known to few digits only. Where polishing follows, it becomes `free`.
  void check_vague(Turn& turn, double free) {
    const double length = std::max(kClose, slack / 10);  // of a vector that has no direction
    if (turn.lever2 > length * length) return;
    is_close = true;
    if (slack > kRounding) turn = Turn::by(free);
  }

  /// Sets the angle of joint i of the shape; false if it is outside its limits. Near an axis an
  /// angle is known to a few digits only, so an angle barely outside is moved onto the limit and
  /// the following joints compensate.
  bool set(int i, Turn& turn) {
    const int joint = arm.joint_[i];
    check_vague(turn, free(i));
    q[joint] = turn.angle;
    if (slack > kRounding) {
      double limit = q[joint];
      return wraps.fits(joint, limit) || wraps.nudge(joint, kLimit, limit);
    }
    if (wraps.fits(joint, q[joint])) return true;
    if (!wraps.nudge(joint, turn.slack(), q[joint])) return false;
    turn = Turn::by(q[joint]);
    return true;
  }

  void run() {
    switch (arm.shape_) {
      case Shape::shoulder_meets:
        return shoulder_meets();
      case Shape::elbow_parallel:
        return elbow_parallel();
      case Shape::three_parallel:
        return three_parallel();
    }
  }

  void shoulder_meets() {
    const Vector3d p_SW = p_PW - arm.shoulder_;
    const double reach = p_SW.norm();
    if (!(reach > kMeet)) return;
    const Vector3d to = p_SW / reach;
    for (Turn turn3 : noted(arm.elbow_.turns(reach, slack))) {
      if (set(2, turn3)) shoulder(reach, to, turn3);
    }
  }

  void shoulder(double reach, const Vector3d& to, const Turn& turn3) {
    const Vector3d& a3 = arm.free_axis_.axis;
    const Vector3d u = third.apply(a3, arm.elbow_.reached(turn3)) / reach;
    const TwoTurns turns = noted(TwoTurns(arm.axis_[0], arm.axis_[1], u, to, slack));
    for (int i = 0; i < turns.count; ++i) {
      const Vector3d z = turns.between(i);
      Turn turn2 = Turn::from_to(arm.axis_[1], u, z, free(1));
      if (!set(1, turn2)) continue;
      Turn turn1 = Turn::from_to(arm.axis_[0], z, to, free(0));
      if (!set(0, turn1)) continue;
      const auto back = [&](const Vector3d& v) {
        const Vector3d v2 = turn2.undo(arm.axis_[1], turn1.undo(arm.axis_[0], v));
        return turn3.undo(arm.axis_[2], third.undo(a3, v2));
      };
      wrist(back(a6), back(b), free(3), [&](auto&...) { accept(); });
    }
  }

  void elbow_parallel() {
    swing([&](const Turn& turn1) {
      const Vector3d p_BW = turn1.undo(arm.axis_[0], p_PW - arm.base_);
      elbow(p_BW, [&](const Turn& turn2, const Turn& turn3) {
        const auto back = [&](const Vector3d& v) {
          const Vector3d v1 = turn1.undo(arm.axis_[0], v);
          return turn3.undo(arm.axis_[2], turn2.undo(arm.axis_[1], v1));
        };
        wrist(back(a6), back(b), free(3), [&](auto&...) { accept(); });
      });
    });
  }

  void three_parallel() {
    const double s1 = arm.axis_[1].dot(arm.axis_[3]), s2 = arm.axis_[2].dot(arm.axis_[3]);  // +-1
    const double free_sum = s1 * free(1) + s2 * free(2) + free(3);
    swing([&](const Turn& turn1) {
      const auto back = [&](const Vector3d& v) { return turn1.undo(arm.axis_[0], v); };
      wrist(back(a6), back(b), free_sum,
            [&](const Turn& sum, const Turn& turn5, const Turn& turn6) {
              const Vector3d p_WC = turn6.undo(arm.axis_[5], turn5.undo(arm.axis_[4], arm.p_W4_));
              elbow(back(p_PW + R * p_WC - arm.base_), [&](const Turn& turn2, const Turn& turn3) {
                Turn turn4;
                turn4.angle =
                    std::remainder(sum.angle - s1 * turn2.angle - s2 * turn3.angle, 2 * M_PI);
                if (set(3, turn4)) accept();
              });
            });
    });
  }

  /// Joint 1: brings the wrist to its distance along the parallel axes.
  template <class Then>
  void swing(const Then& then) {
    const Vector3d& h = arm.axis_[1];
    const double along = h.dot(arm.wrist_ - arm.base_);
    const Vector3d p_BW = p_PW - arm.base_;
    for (Turn turn1 : noted(turns_to_component(-arm.axis_[0], p_BW, h, along, free(0), slack))) {
      if (set(0, turn1)) then(turn1);
    }
  }

  /// Joints 2 and 3, parallel: bring the elbow's moving point to a point, given from the base.
  template <class Then>
  void elbow(const Vector3d& p_BW, const Then& then) {
    const Vector3d p_SW = arm.base_ + p_BW - arm.shoulder_;
    for (Turn turn3 : noted(arm.elbow_.turns(p_SW.norm(), slack))) {
      if (!set(2, turn3)) continue;
      Turn turn2 = Turn::from_to(arm.axis_[1], arm.elbow_.reached(turn3), p_SW, free(1));
      if (set(1, turn2)) then(turn2, turn3);
    }
  }

  /// Joints 4 to 6, or the sum of 2 to 4 in place of 4: turn the last link to its direction.
  template <class Then>
  void wrist(const Vector3d& a6_needed, const Vector3d& b_needed, double free4, const Then& then) {
    const TwoTurns turns =
        noted(TwoTurns(arm.axis_[3], arm.axis_[4], arm.axis_[5], a6_needed, slack));
    for (int i = 0; i < turns.count; ++i) {
      const Vector3d z = turns.between(i);
      Turn turn5 = Turn::from_to(arm.axis_[4], arm.axis_[5], z, free(4));
      if (!set(4, turn5)) continue;
      Turn turn4 = Turn::from_to(arm.axis_[3], z, a6_needed, free4);
      check_vague(turn4, free4);
      if (arm.shape_ != Shape::three_parallel && !set(3, turn4)) continue;
      const Vector3d b5 = turn5.undo(arm.axis_[4], turn4.undo(arm.axis_[3], b_needed));
      Turn turn6 = Turn::from_to(arm.axis_[5], arm.across_, b5, free(5));
      if (set(5, turn6)) then(turn4, turn5, turn6);
    }
  }

  void accept() {
    if (slack == kRounding) {
      count = wraps.append(q, seed, count, solutions);
    } else {
      polish();
    }
  }

  void polish() {
    double better[7];
    std::copy(q, q + 7, better);
    const int n = arm.polish_.size;
    if (!arm.polish_(X_PE, better)) return;
    for (int k = begin; k < count; ++k) {
      double difference = 0;
      for (int i = 0; i < n; ++i) {
        const double other = solutions(wraps.group()[i], k);
        difference = std::max(difference, std::abs(std::remainder(better[i] - other, 2 * M_PI)));
      }
      if (difference < kRepeated) return;
    }
    for (int i = 0; i < n; ++i) {
      if (!wraps.fits(i, better[i])) wraps.nudge(i, Polish::kTolerance, better[i]);
    }
    count = wraps.append(better, seed, count, solutions);
  }
};

/// Returns the required pose of the last of the six joints' links, where the free joint is none of
/// them, seen from the base of the shape. All three poses are X_PE(0) at q = 0.
Isometry3d ClosedForm::target_of_six(const Isometry3d& X_PE, double free_angle) const {
  Isometry3d X = X_PE;
  if (free_ == Free::first) X = motion(free_axis_, -free_angle) * X;
  if (free_ == Free::last) X = X * motion(free_axis_, -free_angle);
  return reversed_ ? polish_.X_PE_zero * X.inverse() * polish_.X_PE_zero : X;
}

int ClosedForm::solve(const Isometry3d& X_PE, double free_angle, const Eigen::VectorXd& q,
                      const Wraps& wraps, int count, Eigen::MatrixXd& solutions) const {
  if (free_ != Free::none && !wraps.fits(free_joint(), free_angle)) return count;
  const Isometry3d X = target_of_six(X_PE, free_angle);
  const Vector3d p_PW = X * p_EW_;
  if (!(p_PW.squaredNorm() < kFar * kFar)) return count;
  const Matrix3d R = X.linear() * R_EP_;
  const Turn third = free_ == Free::third ? Turn::by(free_angle) : Turn{};
  Search search{*this,        X_PE,        q,     wraps,  count, solutions, R, p_PW,
                R * axis_[5], R * across_, third, slack_, false, count,     {}};
  if (free_ != Free::none) search.q[free_joint()] = free_angle;
  search.run();
  if (search.count == count && search.is_close && slack_ < kClose) {
    search.slack = kClose;
    search.run();
  }
  return search.count;
}

}  // namespace graspless::robot
