// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/close.hpp"

#include <algorithm>

namespace graspless::clasp {
namespace {

using Eigen::VectorXd;

// Largest joint steps, Robot::step() [rad].
constexpr double kJointStep = 0.01;         // between collision checks
constexpr double kStride = 5 * kJointStep;  // between rows

class HandCloser {
 public:
  HandCloser(FreeSpace& space, const robot::Robot& robot, const Hand& hand, const VectorXd& q)
      : space_(space),
        robot_(robot),
        joints_(robot.group(hand.hand)),
        closed_(q),
        moves_(VectorXd::Zero(q.size())),
        rows_{q} {
    const VectorXd &open = robot.state(hand.open), closed = robot.clamp(robot.state(hand.closed));
    for (const int joint : joints_) {
      moves_[joint] = 1;
      // A joint with equal open and closed values does not move, and no joint opens.
      if (closed[joint] > open[joint]) closed_[joint] = std::max(q[joint], closed[joint]);
      if (closed[joint] < open[joint]) closed_[joint] = std::min(q[joint], closed[joint]);
    }
  }

  std::vector<VectorXd> close() {
    while (step_together() || step_in_turn()) {
    }
    return thinned();
  }

 private:
  /// Moves all joints that moved last time by a stride, if that is free.
  bool step_together() {
    const VectorXd q = towards(rows_.back(), kStride, moves_);
    if ((q - rows_.back()).isZero(0) || !space_.is_free(rows_.back(), q, kJointStep)) return false;
    rows_.push_back(q);
    return true;
  }

  /// Moves each joint in turn by a small step, if that is free.
  bool step_in_turn() {
    VectorXd q = rows_.back();
    for (const int joint : joints_) {
      const VectorXd next = towards(q, kJointStep, VectorXd::Unit(q.size(), joint));
      moves_[joint] = next[joint] != q[joint] && space_.is_free(next) ? 1 : 0;
      if (moves_[joint] != 0) q = next;
    }
    if ((q - rows_.back()).isZero(0)) return false;
    rows_.push_back(q);
    return true;
  }

  VectorXd towards(const VectorXd& q, double step, const VectorXd& which) const {
    const VectorXd most = step * robot_.step_weights().cwiseInverse();
    return q + (closed_ - q).cwiseMax(-most).cwiseMin(most).cwiseProduct(which);
  }

  /// Drops rows that a straight free motion of at most a stride can skip.
  std::vector<VectorXd> thinned() {
    std::vector<VectorXd> kept{rows_.front()};
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      const bool is_last = i + 1 == rows_.size();
      if (is_last || !can_skip_between(kept.back(), rows_[i + 1])) kept.push_back(rows_[i]);
    }
    return kept;
  }

  bool can_skip_between(const VectorXd& from, const VectorXd& to) {
    return robot_.step(from, to) <= kStride && space_.is_free(from, to, kJointStep);
  }

  FreeSpace& space_;
  const robot::Robot& robot_;
  const std::vector<int>& joints_;
  VectorXd closed_;
  VectorXd moves_;  // 1 for joints that moved last time, else 0
  std::vector<VectorXd> rows_;
};

}  // namespace

std::vector<VectorXd> close_hand(FreeSpace& space, const robot::Robot& robot, const Hand& hand,
                                 const VectorXd& q) {
  return HandCloser(space, robot, hand, q).close();
}

}  // namespace graspless::clasp
