// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compares the frames that a hand's description names with the shapes of its fingers. A wrong frame
// is the likeliest mistake with a new hand, and no other check would notice it.
#include "slide/hand_frames.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace graspless::slide {
namespace {

using Eigen::Vector3d;

constexpr double kAlong = 0.7;  // cosine: within about 45 degrees

/// Mean position of the links' collision shapes, in W, with the hand open [m].
Vector3d middle_of(const Problem& problem, const std::vector<std::string>& links) {
  const robot::Robot& robot = problem.robot;
  robot::Poses X_WL;
  robot.forward(robot.state(problem.hand.open), X_WL);
  Vector3d sum = Vector3d::Zero();
  int count = 0;
  for (const robot::LinkShape& shape : robot.shapes()) {
    const std::string& link = robot.frame_names()[static_cast<std::size_t>(shape.link)];
    if (std::find(links.begin(), links.end(), link) == links.end()) continue;
    sum += (X_WL[static_cast<std::size_t>(shape.link)] * shape.placed.X_BG).translation();
    ++count;
  }
  return sum / std::max(1, count);
}

void require(bool holds, const std::string& field, const std::string& frame,
             const std::string& must) {
  if (holds) return;
  throw std::invalid_argument("hand." + field + " '" + frame + "': " + must +
                              " (judged by the collision shapes of the open hand)");
}

}  // namespace

void check_hand_frames(const Problem& problem) {
  const Hand& hand = problem.hand;
  std::vector<std::string> others;
  for (const std::string& link : hand.fingers) {
    const auto& sliding = hand.sliding_finger;
    if (std::find(sliding.begin(), sliding.end(), link) == sliding.end()) others.push_back(link);
  }
  if (others.empty()) {
    throw std::invalid_argument(
        "hand.fingers must name at least one finger besides hand.sliding_finger");
  }
  const robot::Robot& robot = problem.robot;
  const Eigen::VectorXd& open = robot.state(hand.open);
  const Eigen::Isometry3d X_WF = robot.pose(robot.frame(hand.fingertip), open);
  const Eigen::Isometry3d X_WH = robot.pose(robot.frame(hand.grasp_frame), open);
  const Vector3d finger = middle_of(problem, hand.sliding_finger),
                 other = middle_of(problem, others);
  const Vector3d across = (other - finger).normalized();

  require(X_WF.linear().col(2).dot(X_WF.translation() - finger) > 0, "fingertip", hand.fingertip,
          "its Z axis must point out of the tip");
  require(X_WF.linear().col(1).dot(across) > kAlong, "fingertip", hand.fingertip,
          "its Y axis must point towards the other finger");
  require(X_WH.linear().col(2).dot(X_WH.translation() - (finger + other) / 2) > 0, "grasp_frame",
          hand.grasp_frame,
          "its Z axis must point out of the hand, its origin lie between the open tips");
  require(std::abs(X_WH.linear().col(1).dot(across)) > kAlong, "grasp_frame", hand.grasp_frame,
          "its Y axis must run from finger to finger");
}

}  // namespace graspless::slide
