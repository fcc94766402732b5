// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/center.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graspless/robot/ik.hpp"

#include "clasp/close.hpp"
#include "clasp/hand/palm.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kRounds = 3;
constexpr double kPad = 0.015;    // from the tips to the middle of a pad [m]
constexpr double kEven = 0.0015;  // gaps whose difference is smaller are equal [m]

/// Distance of a finger from the object and the direction in which it touches.
struct Side {
  double gap;
  Vector3d n_W;
};

std::optional<Side> side_of(const std::vector<Touch>& touches) {
  if (touches.empty()) return std::nullopt;
  Side side{touches.front().gap, Vector3d::Zero()};
  for (const Touch& touch : touches) {
    side.gap = std::min(side.gap, touch.gap);
    side.n_W += touch.n_W;
  }
  return side;
}

/// Motion of the hand that makes both gaps equal [m]; nothing if they are.
std::optional<Vector3d> offset_W(Query& query, const VectorXd& q) {
  const auto touches = query.pinching().touches(q);
  const auto finger = side_of(touches[0]), thumb = side_of(touches[1]);
  if (!finger || !thumb || std::abs(finger->gap - thumb->gap) < kEven) return std::nullopt;
  const Vector3d across = finger->n_W.normalized() - thumb->n_W.normalized();
  if (across.norm() < 0.1) return std::nullopt;
  return (finger->gap - thumb->gap) / 2 * across.normalized();
}

Eigen::Isometry3d palm(const Problem& problem, const VectorXd& q) {
  return problem.robot.pose(problem.robot.frame(problem.hand.frame), q);
}

/// The arm with the palm at X_WH; nothing if it cannot.
std::optional<VectorXd> placed(const Problem& problem, const VectorXd& q,
                               const Eigen::Isometry3d& X_WH) {
  const int frame = problem.robot.frame(problem.hand.frame);
  try {
    return robot::Ik(problem.robot, frame, problem.robot.group(problem.hand.arm))
        .solve_near(X_WH, q);
  } catch (const std::invalid_argument&) {  // the arm is not a chain that ends at the palm
    return std::nullopt;
  }
}

/// Palm turned about the target so that the handle runs along its `sideways`, and moved so that the
/// target lies kPad behind the middle of the tips.
Eigen::Isometry3d squared(const Problem& problem, const VectorXd& q,
                          const geometry::ClaspTarget& target_W) {
  const Hand& hand = problem.hand;
  const Eigen::Isometry3d X_WH = palm(problem, q);
  const Vector3d sideways = X_WH.linear() * hand.sideways_H;
  const double sign = sideways.dot(target_W.tangent) < 0 ? -1 : 1;
  const auto turn = Eigen::Quaterniond::FromTwoVectors(sideways, sign * target_W.tangent);
  const Vector3d tips = (node_position(problem.robot, hand.fingers.front().nodes.back(), q) +
                         node_position(problem.robot, hand.thumb.nodes.back(), q)) /
                        2;
  const Vector3d forward = turn * (X_WH.linear() * hand.forward_H);
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = turn * X_WH.linear();
  X.translation() = target_W.point + kPad * forward + turn * (X_WH.translation() - tips);
  return X;
}

}  // namespace

bool square_up(Query& query, const geometry::ClaspTarget& target_W, planning::Path& reach) {
  const auto q =
      placed(query.problem, reach.back(), squared(query.problem, reach.back(), target_W));
  if (!q || !query.is_motion_free(reach.back(), *q)) return false;
  reach.push_back(*q);
  return true;
}

void close_centered(Query& query, planning::Path& reach, planning::Path& close) {
  const Problem& problem = query.problem;
  const auto closed_from = [&](const VectorXd& q) {
    return close_hand(query.free, problem.robot, problem.hand, q);
  };
  close = closed_from(reach.back());
  for (int round = 0; query.may_pinch() && round < kRounds; ++round) {
    const auto by_W = offset_W(query, close.back());
    if (!by_W) return;
    const auto q =
        placed(problem, reach.back(), Eigen::Translation3d(*by_W) * palm(problem, reach.back()));
    if (!q || !query.is_motion_free(reach.back(), *q)) return;
    reach.push_back(*q);
    close = closed_from(*q);
  }
}

}  // namespace graspless::clasp
