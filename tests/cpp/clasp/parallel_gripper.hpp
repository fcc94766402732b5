// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An arm of three sliding joints with a parallel gripper, whose right finger mimics the left.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "graspless/clasp/clasp.hpp"
#include "graspless/robot/robot.hpp"

#include "clasp/ring_problem.hpp"

namespace graspless::clasp {

inline std::string slider(const std::string& name, const std::string& parent,
                          const std::string& child, const std::string& xyz, const std::string& axis,
                          const std::string& range, const std::string& mimic = "",
                          const std::string& effort = "50") {
  return "<joint name='" + name + "' type='prismatic'><origin xyz='" + xyz + "'/><parent link='" +
         parent + "'/><child link='" + child + "'/><axis xyz='" + axis + "'/><limit " + range +
         " velocity='1' effort='" + effort + "'/>" + mimic + "</joint>";
}

inline std::string turner(const std::string& name, const std::string& parent,
                          const std::string& child, const std::string& axis) {
  return "<joint name='" + name + "' type='revolute'><parent link='" + parent + "'/><child link='" +
         child + "'/><axis xyz='" + axis + "'/><limit lower='-2' upper='2' velocity='1' " +
         "effort='50'/></joint><link name='" + child + "'/>";
}

inline std::string box_link(const std::string& name, const std::string& xyz,
                            const std::string& size) {
  return "<link name='" + name + "'><collision><origin xyz='" + xyz + "'/><geometry><box size='" +
         size + "'/></geometry></collision></link>";
}

/// Reads a robot whose hand is `slide_left`, from 0 (closed) to 0.03 (open). `wrist`: joints of the
/// arm besides its three sliders.
inline robot::Robot with_slider_hand(const std::string& urdf, const std::string& wrist = "") {
  const std::string name = urdf.substr(0, urdf.find('>') + 1);  // its tag
  const std::string srdf =
      name + "<group name='arm'><joint name='arm_x'/><joint name='arm_y'/>" + wrist +
      "<joint name='arm_z'/></group><group name='hand'><joint name='slide_left'/></group>"
      "<group_state name='open' group='hand'><joint name='slide_left' value='0.03'/></group_state>"
      "<group_state name='closed' group='hand'><joint name='slide_left' "
      "value='0'/></group_state></robot>";
  robot::Robot::Options options;
  options.srdf = srdf;
  return robot::Robot::from_urdf(urdf, options);
}

/// Fingers of 80 x 20 x 10 mm that are 60 mm apart when open and touch when closed. The palm hangs
/// at (0, 0, 1) and looks along +z. With `turns`, the arm has a wrist of three more joints.
inline robot::Robot parallel_gripper(const std::string& effort = "50", bool turns = false) {
  const std::string far = "lower='-1' upper='1'", near = "lower='0' upper='0.03'";
  const std::string urdf =
      "<robot name='gripper'><link name='world'/><link name='x'/><link name='y'/>" +
      box_link("palm", "0 0 0.02", "0.04 0.1 0.04") +
      box_link("left", "0 0.005 0.04", "0.02 0.01 0.08") +
      box_link("right", "0 -0.005 0.04", "0.02 0.01 0.08") +
      slider("arm_x", "world", "x", "0 0 1", "1 0 0", far) +
      slider("arm_y", "x", "y", "0 0 0", "0 1 0", far) +
      (turns ? turner("roll", "y", "r", "1 0 0") + turner("pitch", "r", "p", "0 1 0") +
                   turner("yaw", "p", "w", "0 0 1")
             : "") +
      slider("arm_z", turns ? "w" : "y", "palm", "0 0 0", "0 0 1", far) +
      slider("slide_left", "palm", "left", "0 0 0.04", "0 1 0", near, "", effort) +
      slider("slide_right", "palm", "right", "0 0 0.04", "0 -1 0", near,
             "<mimic joint='slide_left'/>") +
      "</robot>";
  return with_slider_hand(
      urdf, turns ? "<joint name='roll'/><joint name='pitch'/><joint name='yaw'/>" : "");
}

/// Its curves, with corners on the fingers only.
inline Hand hand_without_palm() {
  Hand hand;
  hand.sideways_H = Eigen::Vector3d::UnitX();
  hand.fingers = {{"left", {{"left", {0, 0, 0.01}}, {"left", {0, 0.005, 0.075}}}}};
  hand.thumb = {"thumb", {{"right", {0, 0, 0.01}}, {"right", {0, -0.005, 0.075}}}};
  return hand;
}

/// A ring of 24 cm above the gripper, its lowest part a bar along x between the fingers; `side` is
/// the displacement across them [m].
inline Problem ring_in_gripper(double thickness, double side = 0, double above = 0) {
  const Object ring = Object::from_cloud(
      "ring", ring_cloud(0.12, thickness, 160, std::max(16, static_cast<int>(800 * thickness))));
  const robot::Robot robot = parallel_gripper();
  Problem problem{robot, with_palm_corners(hand_without_palm(), robot),
                  ring,  Eigen::Isometry3d::Identity(),
                  {},    robot.state("open"),
                  {},    {},
                  {}};
  problem.X_WO.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  problem.X_WO.translation() = Eigen::Vector3d(0, side, 1.21 + above);
  return problem;
}

}  // namespace graspless::clasp
