// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "graspless/realize/realize.hpp"

#include "paths.hpp"

/// Plans made by hand, robots to carry them out, and a block.
namespace graspless::fingertip {

/// Where fingers press: contact point and normal into the object, in O.
using Presses = std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>;

inline Row row(const Eigen::Isometry3d& X_WO, const Presses& presses, int lifted = -1) {
  Row row;
  row.X_WO = X_WO;
  for (std::size_t i = 0; i < presses.size(); ++i) {
    FingerState finger;
    finger.touches = static_cast<int>(i) != lifted;
    finger.p_OC = presses[i].first;
    finger.n_O = presses[i].second;
    row.fingers.push_back(finger);
  }
  return row;
}

/// Rows carry the pose of the arc's beginning: realize() takes poses from Segment::X_WO.
inline Segment displacement(const std::string& name, const Path& path, const Presses& presses) {
  Segment segment;
  segment.name = name;
  segment.X_WO = path.X_WO;
  for (std::size_t i = 0; i + 1 < path.X_WO.size(); ++i) {
    for (int j = 0; j < 3; ++j) segment.rows.push_back(row(path.X_WO[i], presses));
  }
  return segment;
}

inline Segment regrasp(const Eigen::Isometry3d& X_WO, const Presses& presses, int finger) {
  Segment segment;
  segment.name = "regrasp";
  segment.X_WO = {X_WO};
  segment.rows = {row(X_WO, presses, finger)};
  segment.finger = finger;
  return segment;
}

inline Plan solved(std::vector<Segment> segments) {
  Plan plan;
  plan.status = Status::solved;
  plan.segments = std::move(segments);
  return plan;
}

inline Eigen::Isometry3d at(double x, double y, double z, double yaw = 0) {
  Eigen::Isometry3d X;
  X = Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
  return X;
}

/// A standing block, 4 x 4 x 8 cm, tumbled forward over its front edge in six segments.
struct BlockTumble {
  explicit BlockTumble(const Eigen::Vector3d& place = {0.6, 0, 0})
      : start(at(place.x(), place.y(), place.z() + 0.04)),
        path(turn_path(start, place + Eigen::Vector3d(0.02, 0, 0), Eigen::Vector3d::UnitY(),
                       M_PI / 2, 6)),
        problem{Object::box("block", {0.04, 0.04, 0.08}, 0.15),
                fingers(),
                {Plane()},
                {0.8, 0.8},
                path,
                {},
                {0, 0, -9.8}},
        pinch{{{0, -0.02, 0.01}, {0, 1, 0}}, {{0, 0.02, 0.01}, {0, -1, 0}}} {
    problem.planes[0].offset = place.z();
  }
  static Fingers fingers() { return {2, 0.013, 10, {0.8, 0.8}}; }

  Eigen::Isometry3d start;
  Path path;
  Problem problem;
  Presses pinch;
};

inline const robot::Robot& wam_tips() {
  static const auto robot = robot::Robot::from_urdf_file(urdf_file("wam_t42_tips.urdf"));
  return robot;
}

inline Carrier t42() {
  return {{"left_tip_center", "right_tip_center"}, {{"left_finger"}, {"right_finger"}}};
}

inline const robot::Robot& two_arms() {
  static const auto robot = robot::Robot::from_urdf_file(data_file("two_arms.urdf"));
  return robot;
}

inline Carrier two_tips() { return {{"left_tip", "right_tip"}, {{"left_3"}, {"right_3"}}}; }

/// A cube of 6 cm pinched between the arms, slid forward, grasped anew with the right finger behind
/// it, and slid on.
struct CubeSlide {
  CubeSlide()
      : first(slide_path(at(0.22, 0, 0.03), {0.03, 0, 0}, 3)),
        second(slide_path(first.X_WO.back(), {0.03, 0, 0}, 3)),
        problem{Object::box("cube", {0.06, 0.06, 0.06}, 0.2),
                {2, 0.01, 10, {0.7, 0.7}},
                {Plane()},
                {0.5, 0.5},
                join({first, second}),
                {},
                {0, 0, -9.8}},
        pinch{{{0, 0.03, 0}, {0, -1, 0}}, {{0, -0.03, 0}, {0, 1, 0}}},
        behind{pinch[0], {{-0.03, -0.01, 0}, {1, 0, 0}}},
        plan(solved({displacement("slide", first, pinch), regrasp(first.X_WO.back(), pinch, 1),
                     displacement("slide", second, behind)})) {}

  Path first, second;
  Problem problem;
  Presses pinch, behind;
  Plan plan;
};

}  // namespace graspless::fingertip
