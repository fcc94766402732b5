// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"
#include "graspless/slide/slide.hpp"

#include "scene/names.hpp"
#include "slide/contact.hpp"
#include "slide/task/hand_frames.hpp"
#include "text.hpp"

namespace graspless::slide {
namespace {

constexpr std::size_t kLeastJoints = 6;  // of an arm that reaches any pose in some region

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

void check_arm(const Hand& hand, const robot::Robot& robot) {
  const std::size_t count = robot.group(hand.arm).size();
  if (count >= kLeastJoints) return;
  throw std::invalid_argument(
      "hand.arm '" + hand.arm + "' has " + std::to_string(count) +
      " joints; a slide needs 6 or more, as the hand grasps level and square to an edge");
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
  require(hand.finger_model != FingerModel::impedance || hand.wrist_stiffness > 0,
          "hand.wrist_stiffness", hand.wrist_stiffness,
          "must be given [N/m], positive, with hand.finger_model impedance");
}

void check_obstacles(const Problem& problem) {
  collision::require_obstacles(problem.obstacles,
                               scene::taken_names(problem.robot, {"object", "support"}),
                               "a link, another obstacle, 'object' or 'support'");
}

/// Requires an object that lies flat on the support at a pose, which is called `field`.
void check_object_pose(const Problem& problem, const Eigen::Isometry3d& X_WO,
                       const std::string& field) {
  constexpr double kHeight = 0.002, kTilt = 0.0175;  // [m], [rad]
  geometry::require_pose(X_WO, field);
  const Eigen::Isometry3d X_SO = problem.support.X_WS().inverse() * X_WO;
  const double height = X_SO.translation().z();
  const double tilt = std::acos(std::clamp(X_SO.linear()(2, 2), -1.0, 1.0));
  require(std::abs(height) <= kHeight, field + ": height of the object above the support", height,
          "must be within 2 mm");
  require(tilt <= kTilt, field + ": tilt of the object against the support", tilt,
          "must be within 1 degree");
  const Eigen::Vector3d com_S = X_SO * problem.object.com();
  if (!problem.support.polygon().contains(com_S.head<2>())) {
    const std::string where = field == "X_WO_start" ? "" : field + ": ";
    throw std::invalid_argument(where + "object '" + problem.object.name() +
                                "' is off the support: its centre of mass (" + figure(com_S.x()) +
                                ", " + figure(com_S.y()) +
                                ") in the support's frame lies outside the polygon");
  }
}

/// Blames the bound that the options give.
void require_order(const Options& options, const DepthBand& band) {
  if (options.min_depth) {
    require(band.min <= band.max, "options.min_depth", band.min,
            "must be at most max_depth " + figure(band.max));
  } else {
    require(band.min <= band.max, "options.max_depth", band.max,
            "must be at least min_depth " + figure(band.min));
  }
}

/// Requires a band of depths that the finger can yield by.
void check_depths(const Hand& hand, const Options& options) {
  const DepthBand band = depth_band(hand, options);
  require_order(options, band);
  const std::string model = "hand.finger_model " + planning::name_of(hand.finger_model);
  if (hand.finger_model == FingerModel::impedance) {
    require(band.max < kMaxDepth, "hand.wrist_stiffness", hand.wrist_stiffness,
            "must be above " + figure(1.5 * hand.press_force / kMaxDepth) +
                " N/m for hand.press_force " + figure(hand.press_force));
  } else if (hand.finger_model == FingerModel::flexure) {
    const double L = hand.flexure_length;
    const double bent =
        std::sin(options.pitch - options.pitch_tolerance) - (band.max + kHeightTolerance) / L;
    require(bent > 0, "options.max_depth", band.max,
            "would bend a finger with hand.flexure_length " + figure(L) + " flat at this pitch");
  } else {
    require(band.max <= kPadGive, "options.max_depth", band.max,
            "must be at most " + figure(kPadGive) + " m with " + model +
                ": a rigid finger would be driven into object and support");
  }
}

/// The support's drag, which acts below the finger, must not tip the object over its edge.
void check_thickness(const Problem& problem, const Options& options) {
  const Object& object = problem.object;
  const double thickness = object.thickness(), width = object.least_width();
  if (!object.is_thin()) {
    throw std::invalid_argument("object '" + object.name() +
                                "' is not thin: a slide takes a thickness of at most three "
                                "quarters of the width of " +
                                figure(width) + " m, not " + figure(thickness) + " m");
  }
  const double most = width / (2 * thickness * (1 + options.friction_spread)),
               friction = problem.support.friction();
  if (friction <= most) return;
  throw std::invalid_argument("support.friction must be at most " + figure(most) + ", not " +
                              figure(friction) + ", or drag would tip object '" + object.name() +
                              "', which is " + figure(thickness) + " m thick and " + figure(width) +
                              " m wide");
}

/// The object must rest on a tilted support, not slide off by itself.
void check_slope(const Support& support) {
  const Eigen::Vector3d normal_W = support.X_WS().linear().col(2);
  const double slope = normal_W.head<2>().norm() / normal_W.z();
  if (support.friction() >= slope) return;
  throw std::invalid_argument("support.friction must be at least " + figure(slope) +
                              ", the slope of the support, not " + figure(support.friction()) +
                              ": the object would slide off by itself");
}

}  // namespace

void validate(const Problem& problem, bool is_slid) {
  check_hand(problem.hand, problem.robot);
  check_hand_frames(problem);
  if (is_slid) check_closing(problem);
  robot::require_configuration(problem.robot, problem.q_home, "q_home");
  check_object_pose(problem, problem.X_WO_start, "X_WO_start");
  if (problem.X_WO_end) check_object_pose(problem, *problem.X_WO_end, "X_WO_end");
  check_slope(problem.support);
  check_obstacles(problem);
}

void validate(const Options& o) {
  planning::require_in_range("options.", o);
  require(o.pitch - o.pitch_tolerance > 0 && o.pitch + o.pitch_tolerance < M_PI / 2,
          "options.pitch_tolerance", o.pitch_tolerance, "must keep the pitch within (0, pi/2)");
  if (o.min_depth && o.max_depth) require_order(o, {*o.min_depth, *o.max_depth});
}

void validate(const Problem& problem, const Options& options) {
  validate(problem);
  validate(options);
  check_arm(problem.hand, problem.robot);
  check_thickness(problem, options);
  check_depths(problem.hand, options);
  check_finger_fits(problem, options);
  if (problem.X_WO_end && options.search == Search::paper)
    throw std::invalid_argument(
        "options.search must be fast for a slide to an end (X_WO_end), not paper: its goals are "
        "drawn to fit a start");
}

std::string to_string(Status status) { return planning::name_of(status); }

}  // namespace graspless::slide
