// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/model/clearance.hpp"

#include <algorithm>
#include <cmath>

#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kTouchSlack = 1e-9;  // by the object's size
// Steps between two looks at obstacles, as parts of a fingertip's radius and of the object's size.
constexpr double kOfRadius = 0.5, kOfSize = 0.02;
constexpr double kMostSteps = 3000;  // of a way

int add_obstacles(collision::World& world, const std::vector<Obstacle>& obstacles, int moving) {
  for (const Obstacle& obstacle : obstacles) {
    const int body = world.add_body("obstacle " + obstacle.label(), obstacle.solid());
    world.set_pose(body, obstacle.X_WB);
    world.add_pair(moving, body);
  }
  return moving;
}

/// Length of the way of the point that goes farthest, of `points` (3, N) in O [m].
double longest_way(const mechanics::Vector6d& twist_O, const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d v = twist_O.head<3>(), w = twist_O.tail<3>();
  double longest = 0;
  for (const auto& p : points.colwise()) longest = std::max(longest, (v + w.cross(p)).norm());
  return longest;
}

/// True if a test passes at all times of a way at which it is looked at, at least `steps` times.
template <class Test>
bool looks(double steps, int samples, const Test& test) {
  // The middles of the samples' parts are among them if each part has an odd number.
  const double each = std::min(steps, kMostSteps) / samples;
  const int count = samples * (2 * static_cast<int>(std::ceil(std::max(0.0, each - 1) / 2)) + 1);
  for (int i = 0; i < count; ++i) {
    if (!test((i + 0.5) / count)) return false;
  }
  return true;
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
  return is_off_obstacles(center_W);
}

bool Clearance::is_off_obstacles(const Eigen::Vector3d& center_W) {
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

std::string Clearance::obstacle_along(const Eigen::Isometry3d& X_WO,
                                      const mechanics::Vector6d& twist_O, int samples) {
  if (object_ < 0) return "";
  const double step = kOfSize * problem_.object.size();
  std::string found;
  looks(longest_way(twist_O, problem_.object.hull()) / step, samples, [&](double t) {
    found = obstacle_at(along_screw(X_WO, twist_O, t));
    return found.empty();
  });
  return found;
}

bool Clearance::is_off_obstacles_along(const Eigen::Isometry3d& X_WO,
                                       const mechanics::Vector6d& twist_O,
                                       const Eigen::Vector3d& center_O, int samples) {
  if (sphere_ < 0) return true;
  const double step = kOfRadius * problem_.fingers.radius;
  return looks(longest_way(twist_O, center_O) / step, samples, [&](double t) {
    return is_off_obstacles(along_screw(X_WO, twist_O, t) * center_O);
  });
}

}  // namespace graspless::fingertip
