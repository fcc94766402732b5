// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Spheres against planes by arithmetic, spheres and object against obstacles by FCL.
#include "fingertip/model/clearance.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kTouchSlack = 1e-9;  // by the object's size

int add_obstacles(collision::World& world, const std::vector<Obstacle>& obstacles, int moving) {
  for (const Obstacle& obstacle : obstacles) {
    const int body = world.add_body("obstacle " + obstacle.name, obstacle.shapes);
    world.set_pose(body, obstacle.X_WB);
    world.add_pair(moving, body);
  }
  return moving;
}

}  // namespace

Clearance::Clearance(const Problem& problem) : problem_(problem) {
  if (problem.obstacles.empty()) return;
  const geometry::Sphere sphere{problem.fingers.radius};
  sphere_ =
      add_obstacles(for_sphere_, problem.obstacles,
                    for_sphere_.add_body("fingertip", {{sphere, Eigen::Isometry3d::Identity()}}));
  object_ = add_obstacles(for_object_, problem.obstacles,
                          for_object_.add_body("object", problem.object.solid()));
}

bool Clearance::is_clear(const Eigen::Vector3d& center_W) {
  for (const Plane& plane : problem_.planes) {
    const double height = plane.n_W.dot(center_W) - plane.offset;
    if (height < problem_.fingers.radius - kTouchSlack * problem_.object.size()) return false;
  }
  if (sphere_ < 0) return true;
  for_sphere_.set_pose(sphere_, Eigen::Isometry3d(Eigen::Translation3d(center_W)));
  return !for_sphere_.collides();
}

std::string Clearance::obstacle_at(const Eigen::Isometry3d& X_WO) {
  if (object_ < 0) return "";
  for_object_.set_pose(object_, X_WO);
  const auto pair = for_object_.first_collision();
  return pair ? for_object_.name(pair->second) : "";
}

double sphere_speed(const mechanics::Vector6d& twist_O, const Location& location) {
  const Eigen::Vector3d omega_O = twist_O.tail<3>();
  return (twist_O.head<3>() + omega_O.cross(location.center_O)).norm();
}

}  // namespace graspless::fingertip
