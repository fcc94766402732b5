// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Problems that the tests of free space, closing and stability share.
#pragma once

#include <random>
#include <string>

#include "graspless/clasp/problem.hpp"
#include "graspless/clasp/sample_objects.hpp"
#include "graspless/geometry/sampling.hpp"

#include "clasp/hands.hpp"
#include "clasp/ring_problem.hpp"

namespace graspless::clasp {

inline Problem problem_of(const std::string& hand, const Object& object,
                          const Eigen::Isometry3d& X_WO) {
  const RobotWithHand r = robot_with_hand(hand);
  return {r.robot, r.hand, object, X_WO, {}, at_home(r, r.hand.open), {}, {}, {}};
}

/// The purse of our sample objects.
inline const Object& purse() {
  static const Object object =
      Object::from_cloud("purse", geometry::sample_surface(sample_object("purse"), 2000));
  return object;
}

/// A ring 10 cm in radius, a piece of which lies in the hand at q_start along sideways, where the
/// closed hand's middle will be, or so far ahead of it.
inline Problem ring_within(const std::string& hand, double thickness = 0.016, double ahead = 0) {
  constexpr double kRadius = 0.1;
  Problem problem = problem_of(hand, Object::from_cloud("ring", ring_cloud(kRadius, thickness)),
                               Eigen::Isometry3d::Identity());
  const RobotWithHand r{problem.robot, problem.hand};
  const Eigen::Isometry3d X_HW =
      r.robot.pose(r.robot.frame(r.hand.frame), problem.q_start).inverse();
  const Eigen::VectorXd closed = at_home(r, r.hand.closed);
  Eigen::AlignedBox3d box;
  for (const CurveNode& node : r.hand.thumb.nodes) box.extend(X_HW * place(r, node, closed));
  for (const Finger& finger : r.hand.fingers) {
    for (const CurveNode& node : finger.nodes) box.extend(X_HW * place(r, node, closed));
  }
  Eigen::Isometry3d X_HO = Eigen::Isometry3d::Identity();  // the ring's axis is x of O
  X_HO.linear() << r.hand.forward_H.cross(r.hand.sideways_H), r.hand.forward_H, r.hand.sideways_H;
  X_HO.translation() = box.center() + (kRadius + ahead) * r.hand.forward_H;
  problem.X_WO = X_HW.inverse() * X_HO;
  return problem;
}

}  // namespace graspless::clasp
