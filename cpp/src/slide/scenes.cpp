// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/scenes.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::slide {
namespace {

/// How far the sliding finger reaches along a direction of F, beyond F's origin.
double reach_along(const Problem& problem, const Eigen::Vector3d& direction_F) {
  const robot::Robot& robot = problem.robot;
  robot::Poses X_WL;
  robot.forward(robot.state(problem.hand.open), X_WL);
  const Eigen::Isometry3d X_FW = X_WL[static_cast<std::size_t>(robot.frame(problem.hand.fingertip))].inverse();
  double reach = 0;
  for (const robot::LinkShape& shape : robot.shapes()) {
    const std::string& link = robot.frame_names()[static_cast<std::size_t>(shape.link)];
    const auto& finger = problem.hand.sliding_finger;
    if (std::find(finger.begin(), finger.end(), link) == finger.end()) continue;
    geometry::PlacedShape in_F = shape.placed;
    in_F.X_BG = X_FW * X_WL[static_cast<std::size_t>(shape.link)] * shape.placed.X_BG;
    reach = std::max(reach, geometry::extent(in_F, direction_F));
  }
  return reach;
}

}  // namespace

scene::Scene make_scene(const Problem& problem) {
  scene::Scene scene(problem.robot);
  scene.add_obstacle(kSupportBody, problem.support.shapes(), problem.support.X_WS());
  const int object = scene.add_object(kObjectBody, problem.object.shapes());
  for (const Obstacle& obstacle : problem.obstacles) {
    const int body = scene.add_obstacle(obstacle.name, obstacle.shapes, obstacle.X_WB);
    scene.world().add_pair(object, body);
  }
  scene.move_object(object, problem.X_WO_start);
  return scene;
}

Eigen::Isometry3d parked() {
  constexpr double kFar = 1e3;
  return Eigen::Isometry3d(Eigen::Translation3d(0, 0, kFar));
}

PressDepths press_depths(const Problem& problem, const Options& options, double depth) {
  double below_tip = 0;  // of the finger's lowest point under the tip frame's origin
  constexpr int kSamples = 9;
  for (int i = 0; i < kSamples; ++i) {
    const double pitch =
        options.pitch + options.pitch_tolerance * (2.0 * i / (kSamples - 1) - 1);
    const Eigen::Vector3d down_F(0, -std::cos(pitch), std::sin(pitch));
    below_tip = std::max(below_tip, reach_along(problem, down_F));
  }
  constexpr double kRoundOff = 1e-4;
  const double deepest = depth + below_tip + options.height_tolerance + kRoundOff;
  return {deepest, std::max(0.0, deepest - problem.object.thickness())};
}

void allow_press(const Problem& problem, const Options& options, double depth, scene::Scene& scene) {
  const PressDepths depths = depth < 0 ? PressDepths{0, 0} : press_depths(problem, options, depth);
  collision::World& world = scene.world();
  const Eigen::Vector3d normal_W = problem.support.normal_W();
  for (const std::string& link : problem.hand.sliding_finger) {
    const int body = scene.link_body(problem.robot.frame(link));
    if (body < 0) continue;
    world.allow_contact(body, world.body(kObjectBody), normal_W, depths.into_object);
    world.allow_contact(body, world.body(kSupportBody), normal_W, depths.into_support);
  }
}

}  // namespace graspless::slide
