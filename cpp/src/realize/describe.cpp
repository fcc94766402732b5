// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Reasons why a configuration will not do, and what to change.
#include "realize/hand.hpp"
#include "robot/names.hpp"
#include "text.hpp"

namespace graspless::realize {

std::string describe_collision(Hand& hand, const Eigen::VectorXd& q) {
  const auto [a, b] = hand.scene.scene().collision(q);
  if (a.empty()) return "";
  const auto& links = hand.ik.robot().frame_names();
  const std::string& object = hand.scene.scene().world().name(hand.scene.object());
  std::string change = "another pose of the object may help";
  if (a == object || b == object) {
    change = "a hand that opens wider, or a narrower object, leaves room";
  } else if (!robot::contains(links, b)) {
    change = "farther from '" + b + "', the object leaves room";
  }
  return "'" + a + "' touches '" + b + "': " + change;
}

std::string describe_miss(Hand& hand, const TipTargets& targets, const Eigen::VectorXd& q) {
  const auto [distance, finger] = hand.ik.miss(targets, q);
  return "fingertip '" + hand.ik.fingertip(finger) + "' misses the place of finger " +
         std::to_string(finger) + " by " + figure(1e3 * distance, 3) +
         " mm: nearer to the robot, or turned about the vertical, the object may be in reach";
}

}  // namespace graspless::realize
