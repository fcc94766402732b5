// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Continuation of fingertip positions: steps of least norm, halved until no joint jumps and the
// fingertips stay on their paths between rows too.
#include "realize/track.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "fingertip/model/screw.hpp"

namespace graspless::realize {
namespace {

constexpr int kIterations = 15;
constexpr double kPull = 0.3;             // of max_jump, per row: the null space's share
constexpr double kLeastStep = 1.0 / 512;  // of a part
constexpr double kNearLimit = 0.85;       // of half a joint's range: where it is pulled back

/// q moved by at most `pull` in any joint: towards the bias, else off the limits that are near.
Eigen::VectorXd pulled(const Hand& hand, const Eigen::VectorXd& q, const Bias& bias, double pull) {
  const robot::Robot& robot = hand.ik.robot();
  Eigen::VectorXd out = q;
  for (const int joint : hand.ik.joints()) {
    const double half = (robot.upper()[joint] - robot.lower()[joint]) / 2;
    const double middle = robot.lower()[joint] + half;
    double aim = q[joint];
    if (bias)
      aim = (*bias)[joint];
    else if (std::abs(q[joint] - middle) > kNearLimit * half)
      aim = middle;
    out[joint] += std::clamp(aim - q[joint], -pull, pull);
  }
  return out;
}

class Tracker {
 public:
  Tracker(Hand& hand, const Stretch& stretch, const Bias& bias)
      : hand_(hand), stretch_(stretch), bias_(bias) {}

  Tracked run(const Eigen::VectorXd& q) {
    hand_.scene.place_object(stretch_.pose(0));
    push(q, 0);
    const int parts = stretch_.arcs() * stretch_.parts;
    for (int part = 0; part < parts && out_.fault.empty(); ++part) {
      follow(1.0 * part / stretch_.parts, (part + 1.0) / stretch_.parts);
    }
    return std::move(out_);
  }

 private:
  void push(const Eigen::VectorXd& q, double s) {
    out_.positions.push_back(q);
    out_.X_WO.push_back(stretch_.pose(s));
    out_.reached = s;
  }

  /// Rows from s1 to s2, at least one.
  void follow(double s1, double s2) {
    double fraction = 0, step = 1;
    while (fraction < 1) {
      const double next = std::min(1.0, fraction + step);
      const double s = next == 1 ? s2 : s1 + next * (s2 - s1);
      const auto q = advance(s, step);
      if (!q && step > kLeastStep) {
        step /= 2;
        continue;
      }
      if (!q) return blame(s);
      const Eigen::VectorXd& from = out_.positions.back();
      hand_.scene.place_object(out_.X_WO.back());
      if (!hand_.scene.is_motion_free(from, *q, stretch_.pose(s), hand_.options.resolution)) {
        out_.fault = describe_collision(hand_, *q);
        if (out_.fault.empty()) out_.fault = "something touches on the way to the next row";
        return;
      }
      push(*q, s);
      fraction = next;
      step = std::min(2 * step, 1.0);
    }
  }

  /// The configuration at s that continues the last row's; nothing when the step is too long.
  std::optional<Eigen::VectorXd> advance(double s, double share) {
    const double jump = hand_.options.max_jump;
    const Eigen::VectorXd& from = out_.positions.back();
    Eigen::VectorXd q = pulled(hand_, along(from, s), bias_, share * kPull * jump);
    if (!hand_.ik.solve(stretch_.targets(s), kIkTolerance, kIterations, q)) return std::nullopt;
    if ((q - from).lpNorm<Eigen::Infinity>() > jump) return std::nullopt;
    const double halfway = (out_.reached + s) / 2;
    const double off = hand_.ik.miss(stretch_.targets(halfway), (from + q) / 2).first;
    if (off > 0.8 * hand_.options.position_tolerance) return std::nullopt;
    return q;
  }

  Eigen::VectorXd along(const Eigen::VectorXd& q, double s) {
    if (stretch_.n_O.cols() == 0) return q;
    const Eigen::Isometry3d X_WO = stretch_.pose(s);
    const Eigen::AngleAxisd turn(X_WO.linear() * out_.X_WO.back().linear().transpose());
    return hand_.ik.step_along(stretch_.targets(s), turn.angle() * turn.axis(),
                               X_WO.linear() * stretch_.n_O, q);
  }

  void blame(double s) {
    Eigen::VectorXd q = out_.positions.back();
    if (hand_.ik.solve(stretch_.targets(s), kIkTolerance, 4 * kIterations, q)) {
      out_.fault = "the arm would have to jump: another pose of the object may help";
    } else {
      out_.fault = describe_miss(hand_, stretch_.targets(s), q);
    }
  }

  Hand& hand_;
  const Stretch& stretch_;
  const Bias& bias_;
  Tracked out_;
};

}  // namespace

Eigen::Isometry3d Stretch::pose(double s) const {
  if (X_WO.size() < 2) return X_WO.front();
  const int arc = std::clamp(static_cast<int>(std::floor(s)), 0, arcs() - 1);
  const auto i = static_cast<std::size_t>(arc);
  return fingertip::along_screw(X_WO[i], fingertip::screw_between(X_WO[i], X_WO[i + 1]), s - arc);
}

TipTargets Stretch::targets(double s) const {
  const Eigen::Isometry3d X = pose(s);
  Eigen::Matrix3Xd p_OT = from_O + s / arcs() * (to_O - from_O);
  return {(X.linear() * p_OT).colwise() + X.translation(), held};
}

Tracked track(Hand& hand, const Stretch& stretch, const Eigen::VectorXd& q, const Bias& bias) {
  return Tracker(hand, stretch, bias).run(q);
}

double scrub(const Hand& hand, const JointSegment& rows, const Eigen::Matrix3Xd& n_O,
             FingerMask held) {
  double worst = 0;
  for (int i = 0; i < static_cast<int>(n_O.cols()); ++i) {
    if ((held >> i & 1U) == 0) continue;
    double turned = 0;
    Eigen::Matrix3d R_before;
    for (std::size_t row = 0; row < rows.positions.size(); ++row) {
      const Eigen::Matrix3d R_OF =
          rows.X_WO[row].linear().transpose() * hand.ik.pose(i, rows.positions[row]).linear();
      if (row > 0) {
        const Eigen::AngleAxisd turn(R_OF * R_before.transpose());
        turned += (turn.angle() * turn.axis()).cross(n_O.col(i)).norm();
      }
      R_before = R_OF;
    }
    worst = std::max(worst, hand.radius * turned);
  }
  return worst;
}

}  // namespace graspless::realize
