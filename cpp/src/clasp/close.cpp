// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/close.hpp"

#include <algorithm>

namespace graspless::clasp {
namespace {

using Eigen::VectorXd;

constexpr double kStep = 0.01;         // of a joint, between configurations looked at
constexpr double kStride = 5 * kStep;  // between rows, and of all joints at once in the open

class Closing {
 public:
  Closing(FreeSpace& space, const robot::Robot& robot, const Hand& hand, const VectorXd& q)
      : space_(space),
        joints_(robot.group(hand.hand)),
        closed_(q),
        moves_(VectorXd::Zero(q.size())),
        rows_{q} {
    const VectorXd &open = robot.state(hand.open), closed = robot.clamp(robot.state(hand.closed));
    for (const int joint : joints_) {
      moves_[joint] = 1;
      // A joint that is open and closed at one value does not close, and none ever opens.
      if (closed[joint] > open[joint]) closed_[joint] = std::max(q[joint], closed[joint]);
      if (closed[joint] < open[joint]) closed_[joint] = std::min(q[joint], closed[joint]);
    }
  }

  std::vector<VectorXd> close() {
    while (stride() || turn_in_turn()) {
    }
    return thinned();
  }

 private:
  /// Every joint that moved last time at once.
  bool stride() {
    const VectorXd q = towards(rows_.back(), kStride, moves_);
    if ((q - rows_.back()).isZero(0) || !space_.is_free(rows_.back(), q, kStep)) return false;
    rows_.push_back(q);
    return true;
  }

  /// One joint after the other.
  bool turn_in_turn() {
    VectorXd q = rows_.back();
    for (const int joint : joints_) {
      const VectorXd next = towards(q, kStep, VectorXd::Unit(q.size(), joint));
      moves_[joint] = next[joint] != q[joint] && space_.is_free(next) ? 1 : 0;
      if (moves_[joint] != 0) q = next;
    }
    if ((q - rows_.back()).isZero(0)) return false;
    rows_.push_back(q);
    return true;
  }

  VectorXd towards(const VectorXd& q, double step, const VectorXd& which) const {
    return q + (closed_ - q).cwiseMax(-step).cwiseMin(step).cwiseProduct(which);
  }

  /// Without the rows that a straight free motion of at most a stride may leave out.
  std::vector<VectorXd> thinned() {
    std::vector<VectorXd> kept{rows_.front()};
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      const bool is_last = i + 1 == rows_.size();
      if (is_last || !may_leave_out(kept.back(), rows_[i + 1])) kept.push_back(rows_[i]);
    }
    return kept;
  }

  bool may_leave_out(const VectorXd& from, const VectorXd& to) {
    return (to - from).cwiseAbs().maxCoeff() <= kStride && space_.is_free(from, to, kStep);
  }

  FreeSpace& space_;
  const std::vector<int>& joints_;
  VectorXd closed_;
  VectorXd moves_;  // 1 for a joint that moved last time
  std::vector<VectorXd> rows_;
};

}  // namespace

std::vector<VectorXd> close_hand(FreeSpace& space, const robot::Robot& robot, const Hand& hand,
                                 const VectorXd& q) {
  return Closing(space, robot, hand, q).close();
}

}  // namespace graspless::clasp
