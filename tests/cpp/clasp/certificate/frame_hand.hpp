// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A hand whose gap is known: two jaws that form a frame, open at the top.
#pragma once

#include <string>

#include "graspless/clasp/hand.hpp"
#include "graspless/clasp/problem.hpp"

#include "clasp/parallel_gripper.hpp"
#include "clasp/ring_problem.hpp"

namespace graspless::clasp {

constexpr double kFrameBall = 0.005;  // radius of the balls that the frame is made of [m]

/// Balls in a row from (y, z) to (y2, z2), at most 4 mm apart [m].
inline std::string ball_row(double y, double z, double y2, double z2) {
  const double length = std::hypot(y2 - y, z2 - z);
  const int gaps = static_cast<int>(std::ceil(length / 0.004));
  std::string row;
  for (int i = 0; i <= gaps; ++i) {
    const double t = static_cast<double>(i) / gaps;
    row += "<collision><origin xyz='0 " + std::to_string(y + t * (y2 - y)) + " " +
           std::to_string(z + t * (z2 - z)) + "'/><geometry><sphere radius='" +
           std::to_string(kFrameBall) + "'/></geometry></collision>";
  }
  return row;
}

/// Frame of 80 x 80 mm in the plane y-z above the palm. Joint `slide_left` opens each jaw by its
/// value [m]; the gap between the jaws is twice that.
inline robot::Robot frame_robot() {
  const auto jaw = [](const std::string& name, double side) {
    return "<link name='" + name + "'>" + ball_row(side * 0.04, 0, side * 0.04, 0.08) +
           ball_row(side * 0.04, 0.08, side * kFrameBall, 0.08) + "</link>";
  };
  const std::string far = "lower='-1' upper='1'", near = "lower='0' upper='0.03'";
  const std::string urdf =
      "<robot name='frame'><link name='world'/><link name='x'/><link name='y'/><link name='palm'>" +
      ball_row(-0.07, 0, 0.07, 0) + "</link>" + jaw("left", 1) + jaw("right", -1) +
      slider("arm_x", "world", "x", "0 0 1", "1 0 0", far) +
      slider("arm_y", "x", "y", "0 0 0", "0 1 0", far) +
      slider("arm_z", "y", "palm", "0 0 0", "0 0 1", far) +
      slider("slide_left", "palm", "left", "0 0 0", "0 1 0", near) +
      slider("slide_right", "palm", "right", "0 0 0", "0 -1 0", near,
             "<mimic joint='slide_left'/>") +
      "</robot>";
  return with_slider_hand(urdf);
}

inline Hand frame_hand() {
  Hand hand;
  hand.sideways_H = Eigen::Vector3d::UnitX();
  const auto corners = [](const std::string& jaw, double side) -> std::vector<CurveNode> {
    return {{"palm", {0, side * 0.02, 0}},
            {jaw, {0, side * 0.04, 0}},
            {jaw, {0, side * 0.04, 0.08}},
            {jaw, {0, side * kFrameBall, 0.08}}};
  };
  hand.fingers = {{"left", corners("left", 1)}};
  hand.thumb = {"thumb", corners("right", -1)};
  return hand;
}

/// A ring about the y axis, of radius 60 mm, whose lowest point is in the middle of the frame.
/// The gap is `gap` [m]; configuration of all joints in q_start.
inline Problem frame_problem(double gap, double thickness = 0.016) {
  Eigen::Matrix3Xd cloud = ring_cloud(0.06, thickness, 60, 12);
  cloud.row(0).swap(cloud.row(1));
  Problem problem{frame_robot(),
                  frame_hand(),
                  Object::from_cloud("ring", cloud),
                  Eigen::Isometry3d::Identity(),
                  {},
                  {},
                  {},
                  {},
                  {}};
  problem.X_WO.translation() = Eigen::Vector3d(0, 0, 1 + 0.04 + 0.06);
  problem.q_start = problem.robot.state("open");
  problem.q_start[problem.robot.group("hand")[0]] = gap / 2;
  return problem;
}

}  // namespace graspless::clasp
