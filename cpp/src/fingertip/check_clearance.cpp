// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(): what fingertips and object must not touch. Against planes and each other by distances of
// centres, against object and obstacles by FCL.
#include <algorithm>

#include "graspless/collision/world.hpp"

#include "fingertip/check.hpp"

namespace graspless::fingertip::checking {
namespace {

// Of a sphere's radius: left out of FCL's tests, where just touching counts as touching.
constexpr double kSkin = 1e-3;

}  // namespace

/// Object, obstacles and spheres of one radius.
struct Examination::World {
  World(const Problem& problem, double radius) {
    object = world.add_body("the object", problem.object.solid());
    for (const Obstacle& obstacle : problem.obstacles) {
      const int body = world.add_body("obstacle '" + obstacle.name + "'", obstacle.shapes);
      world.set_pose(body, obstacle.X_WB);
      world.add_pair(object, body);
    }
    for (int i = 0; i < problem.fingers.count; ++i) {
      const geometry::PlacedShape sphere{geometry::Sphere{radius}, Eigen::Isometry3d::Identity()};
      const int finger = world.add_body("finger " + std::to_string(i), {sphere});
      for (int body = 0; body < finger - i; ++body) world.add_pair(body, finger);
      fingers.push_back(finger);
    }
  }
  collision::World world;
  int object;
  std::vector<int> fingers;
};

/// How far a sphere's way leaves the chord between two poses, at most.
double Examination::bulge() const {
  double most = 0;
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) {
    if (is_regrasp(s)) continue;
    for (std::size_t arc = 0; arc + 1 < segment(s).X_WO.size(); ++arc) {
      const Vector6d twist = arc_twist(s, arc);
      for (const FingerState& finger : segment(s).rows[0].fingers) {
        const Eigen::Vector3d way = twist.head<3>() + twist.tail<3>().cross(center(finger));
        most = std::max(most, way.norm() * twist.tail<3>().norm() / 8);
      }
    }
  }
  return most;
}

void Examination::check_clearances() {
  const double radius = (1 - kSkin) * problem_.fingers.radius;
  World at_poses(problem_, radius);
  // Clear at two poses, a sphere may still graze a flat side in between, by the bulge of its way.
  World between(problem_, std::max(radius - bulge(), kSkin * radius));
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) {
    const Row& row = segment(s).rows[0];
    for (std::size_t k = 0; k < segment(s).X_WO.size(); ++k) {
      check_spheres(s, k);
      check_world(at_poses, place(s) + ", pose " + std::to_string(k), row, segment(s).X_WO[k]);
    }
    for (std::size_t r = 0; r < segment(s).rows.size() && !is_regrasp(s); ++r) {
      check_world(between, place(s, r), row, row_pose(s, r));
    }
  }
}

/// Fingertips above the planes and apart from each other.
void Examination::check_spheres(std::size_t s, std::size_t pose) {
  const Row& row = segment(s).rows[0];
  const std::string where = place(s) + ", pose " + std::to_string(pose);
  const double radius = problem_.fingers.radius;
  for (std::size_t i = 0; i < row.fingers.size(); ++i) {
    if (!row.fingers[i].touches) continue;
    const std::string who = "finger " + std::to_string(i);
    const Eigen::Vector3d center_W = segment(s).X_WO[pose] * center(row.fingers[i]);
    for (const Plane& plane : problem_.planes) {
      const double depth = radius - (plane.n_W.normalized().dot(center_W) - plane.offset);
      if (depth > same_length_) {
        fault(where, who + " reaches " + figure(depth) + " m into plane '" + plane.name + "'");
      }
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!row.fingers[j].touches) continue;
      const double apart = (center(row.fingers[i]) - center(row.fingers[j])).norm();
      if (apart < 2 * radius - same_length_) {
        fault(where, who + " overlaps finger " + std::to_string(j));
      }
      if (apart > problem_.fingers.max_span + same_length_) {
        fault(where, who + " is " + figure(apart) + " m from finger " + std::to_string(j) +
                         ", more than fingers.max_span");
      }
    }
  }
}

void Examination::check_world(World& world, const std::string& where, const Row& row,
                              const Eigen::Isometry3d& X_WO) {
  world.world.set_pose(world.object, X_WO);
  for (std::size_t i = 0; i < row.fingers.size(); ++i) {
    const Eigen::Vector3d center_O = center(row.fingers[i]);
    world.world.set_pose(world.fingers[i], X_WO * Eigen::Translation3d(center_O));
  }
  for (const auto& [a, b] : world.world.all_collisions()) {
    const int finger = b - world.fingers[0];
    if (finger >= 0 && !row.fingers[static_cast<std::size_t>(finger)].touches) continue;
    fault(where, world.world.name(b) + " touches " + world.world.name(a));
  }
}

}  // namespace graspless::fingertip::checking
