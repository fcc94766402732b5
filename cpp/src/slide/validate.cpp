// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"
#include "graspless/slide/slide.hpp"

#include "slide/contact.hpp"
#include "slide/hand_frames.hpp"

namespace graspless::slide {
namespace {

void require(bool holds, const std::string& field, double value, const std::string& must) {
  if (!holds) throw std::invalid_argument(field + " " + must + ", not " + std::to_string(value));
}

/// Requires that the arm moves the frame.
void check_carried(const Hand& hand, const robot::Robot& robot, const std::string& field,
                   const std::string& link) {
  const int last = robot.group(hand.arm).back();
  Eigen::VectorXd q = robot.state(hand.open);
  const Eigen::Isometry3d before = robot.pose(robot.frame(link), q);
  q[last] += 0.5;
  if (!before.isApprox(robot.pose(robot.frame(link), q), 1e-12)) return;
  throw std::invalid_argument("hand." + field + " '" + link + "' is not carried by the group '" +
                              hand.arm + "': its last joint does not move it");
}

void check_links(const robot::Robot& robot, const std::string& field,
                 const std::vector<std::string>& links) {
  bool shaped = false;
  for (const std::string& link : links) {
    const int frame = robot.frame(link);
    for (const auto& shape : robot.shapes()) shaped = shaped || shape.link == frame;
  }
  if (shaped) return;
  throw std::invalid_argument("hand." + field +
                              " must name at least one link with a collision shape");
}

void check_hand(const Hand& hand, const robot::Robot& robot) {
  if (robot.group(hand.arm).empty()) {
    throw std::invalid_argument("hand.arm '" + hand.arm + "' is a group without joints");
  }
  robot.state(hand.open);
  robot.state(hand.closed);
  check_carried(hand, robot, "fingertip", hand.fingertip);
  check_carried(hand, robot, "grasp_frame", hand.grasp_frame);
  check_links(robot, "sliding_finger", hand.sliding_finger);
  check_links(robot, "fingers", hand.fingers);
  planning::require_in_range("hand.", hand);
}

void check_obstacles(const Problem& problem) {
  std::set<std::string> taken{"object", "support"};
  for (const std::string& link : problem.robot.frame_names()) taken.insert(link);
  collision::require_obstacles(problem.obstacles, taken,
                               "a link, another obstacle, 'object' or 'support'");
}

void check_object_pose(const Problem& problem) {
  constexpr double kHeight = 0.002, kTilt = 0.0175;  // [m], [rad]
  const Eigen::Isometry3d X_SO = problem.support.X_WS().inverse() * problem.X_WO_start;
  const double height = X_SO.translation().z();
  const double tilt = std::acos(std::min(1.0, X_SO.linear()(2, 2)));
  require(std::abs(height) <= kHeight, "X_WO_start: height of the object above the support", height,
          "must be within 2 mm");
  require(tilt <= kTilt, "X_WO_start: tilt of the object against the support", tilt,
          "must be within 1 degree");
  const Eigen::Vector3d com_S = X_SO * problem.object.com();
  if (!problem.support.polygon().contains(com_S.head<2>())) {
    throw std::invalid_argument("object '" + problem.object.name() +
                                "' is off the support: its centre of mass (" +
                                std::to_string(com_S.x()) + ", " + std::to_string(com_S.y()) +
                                ") in the support's frame lies outside the polygon");
  }
}

}  // namespace

void validate(const Problem& problem) {
  check_hand(problem.hand, problem.robot);
  check_hand_frames(problem);
  robot::require_configuration(problem.robot, problem.q_home, "q_home");
  geometry::require_pose(problem.X_WO_start, "X_WO_start");
  check_object_pose(problem);
  check_obstacles(problem);
}

void validate(const Options& o) {
  planning::require_in_range("options.", o);
  const double half_pi = std::acos(0.0);
  require(o.pitch - o.pitch_tolerance > 0 && o.pitch + o.pitch_tolerance < half_pi,
          "options.pitch_tolerance", o.pitch_tolerance, "must keep the pitch within (0, pi/2)");
  require(o.max_depth >= o.min_depth, "options.max_depth", o.max_depth,
          "must be at least min_depth = " + std::to_string(o.min_depth));
}

void validate(const Problem& problem, const Options& options) {
  validate(problem);
  validate(options);
  if (problem.hand.finger_model == FingerModel::none) return;
  const double L = problem.hand.flexure_length;
  const double bent = std::sin(options.pitch - options.pitch_tolerance) -
                      (options.max_depth + kHeightTolerance) / L;
  require(
      bent > 0, "options.max_depth", options.max_depth,
      "would bend a finger with hand.flexure_length " + std::to_string(L) + " flat at this pitch");
}

std::string to_string(Status status) { return planning::name_of(status); }

}  // namespace graspless::slide
