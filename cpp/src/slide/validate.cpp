// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graspless/slide/slide.hpp"

namespace graspless::slide {
namespace {

void require(bool holds, const std::string& field, double value, const std::string& must) {
  if (!holds) throw std::invalid_argument(field + " " + must + ", not " + std::to_string(value));
}

void check_hand(const Hand& hand, const robot::Robot& robot) {
  robot.group(hand.arm);
  robot.frame(hand.fingertip);
  robot.frame(hand.grasp_frame);
  for (const std::string& link : hand.sliding_finger) robot.frame(link);
  for (const std::string& link : hand.fingers) robot.frame(link);
  robot.state(hand.open);
  robot.state(hand.closed);
  require(hand.flexure_length > 0, "hand.flexure_length", hand.flexure_length, "must be positive");
  require(hand.tip_radius >= 0, "hand.tip_radius", hand.tip_radius, "must not be negative");
}

void check_home(const Problem& problem) {
  const robot::Robot& robot = problem.robot;
  if (problem.q_home.size() != robot.dof()) {
    throw std::invalid_argument("q_home has " + std::to_string(problem.q_home.size()) +
                                " values for " + std::to_string(robot.dof()) + " joints");
  }
  for (int i = 0; i < robot.dof(); ++i) {
    const double q = problem.q_home[i];
    if (q >= robot.lower()[i] - 1e-9 && q <= robot.upper()[i] + 1e-9) continue;
    throw std::invalid_argument(
        "q_home: joint '" + robot.joint_names()[static_cast<std::size_t>(i)] + "' is " +
        std::to_string(q) + ", outside its limits [" + std::to_string(robot.lower()[i]) + ", " +
        std::to_string(robot.upper()[i]) + "]");
  }
}

void check_object_pose(const Problem& problem) {
  constexpr double kHeight = 0.002, kTilt = 0.0175;  // [m], [rad]
  const Eigen::Isometry3d X_SO = problem.support.X_WS().inverse() * problem.X_WO_start;
  if (!X_SO.matrix().allFinite()) throw std::invalid_argument("X_WO_start is not finite");
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
  check_home(problem);
  check_object_pose(problem);
  for (const Obstacle& obstacle : problem.obstacles) {
    for (const auto& placed : obstacle.shapes) {
      geometry::validate(placed.shape, "obstacle '" + obstacle.name + "'");
    }
  }
}

void validate(const Options& o) {
  const double half_pi = std::acos(0.0);
  require(o.pitch > 0 && o.pitch < half_pi, "options.pitch", o.pitch,
          "must lie between 0 and pi/2");
  require(o.pitch_tolerance > 0 && o.pitch - o.pitch_tolerance > 0 &&
              o.pitch + o.pitch_tolerance < half_pi,
          "options.pitch_tolerance", o.pitch_tolerance,
          "must be positive and keep the pitch within (0, pi/2)");
  require(o.min_depth >= 0, "options.min_depth", o.min_depth, "must not be negative");
  require(o.max_depth >= o.min_depth, "options.max_depth", o.max_depth,
          "must be at least min_depth = " + std::to_string(o.min_depth));
  require(o.max_depth < 0.1, "options.max_depth", o.max_depth, "must be below 0.1 m");
  require(o.height_tolerance > 0, "options.height_tolerance", o.height_tolerance,
          "must be positive");
  require(o.roll_tolerance > 0, "options.roll_tolerance", o.roll_tolerance, "must be positive");
  require(o.root_scale > 0, "options.root_scale", o.root_scale, "must be positive");
  require(o.min_overhang > 0, "options.min_overhang", o.min_overhang, "must be positive");
  require(o.com_margin >= 0, "options.com_margin", o.com_margin, "must not be negative");
  require(o.tip_margin >= 0, "options.tip_margin", o.tip_margin, "must not be negative");
  require(o.lift_height > 0, "options.lift_height", o.lift_height, "must be positive");
  require(o.grasp_approach > 0, "options.grasp_approach", o.grasp_approach, "must be positive");
  require(o.range > 0 && o.range <= 1, "options.range", o.range, "must lie in (0, 1]");
  require(o.resolution > 0 && o.resolution <= 0.05, "options.resolution", o.resolution,
          "must lie in (0, 0.05]");
}

std::string to_string(Status status) {
  switch (status) {
    case Status::solved:
      return "solved";
    case Status::start_in_collision:
      return "start_in_collision";
    case Status::no_start_root:
      return "no_start_root";
    case Status::no_goal_root:
      return "no_goal_root";
    case Status::no_valid_pair:
      return "no_valid_pair";
    case Status::not_connected:
      return "not_connected";
    case Status::interrupted:
      return "interrupted";
  }
  return "unknown";
}

}  // namespace graspless::slide
