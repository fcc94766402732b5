// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/scenes.hpp"

namespace graspless::slide {
scene::Scene make_scene(const Problem& problem) {
  scene::Scene scene(problem.robot);
  scene.add_obstacle(kSupportBody, problem.support.solid(), problem.support.X_WS());
  const int object = scene.add_object(kObjectBody, problem.object.solid());
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

}  // namespace graspless::slide
