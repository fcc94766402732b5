// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(): where the fingers are on the object, that they stay there but for regrasps, and what
// fingertips and object must not touch. Distances of centres tell about planes and other fingers,
// FCL about object and obstacles.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "graspless/collision/world.hpp"

#include "fingertip/check/check.hpp"
#include "geometry/segment.hpp"
#include "text.hpp"

namespace graspless::fingertip::checking {
namespace {

bool is_same_contact(const FingerState& a, const FingerState& b, double length) {
  return (a.p_OC - b.p_OC).norm() <= length && (a.n_O - b.n_O).norm() <= 1e-9;
}

/// Distance from a point to a triangle with the unit normal n. It is measured straight down where
/// the foot falls inside, else to the nearest side.
double distance_to_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d (&corner)[3],
                            const Eigen::Vector3d& n) {
  bool inside = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d &a = corner[i], &b = corner[(i + 1) % 3];
    inside = inside && (b - a).cross(p - a).dot(n) >= 0;
    nearest = std::min(nearest, geometry::distance_to_segment(p, a, b));
  }
  return inside ? std::abs(n.dot(p - corner[0])) : nearest;
}

// Part of a sphere's radius that FCL's tests leave out, because FCL counts just touching as a
// collision.
constexpr double kSkin = 1e-3;
constexpr double kMostLooks = 3000;  // at obstacles, along one arc

/// True if a point lies on a mesh's surface (to `tolerance` [m]) where the inward normal is n_O.
bool is_on_surface(const geometry::Mesh& mesh, const Eigen::Vector3d& p_O,
                   const Eigen::Vector3d& n_O, double tolerance) {
  constexpr double kCosine = 1 - 5e-5;  // 0.01 rad: a face can have triangles that are so far apart
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Eigen::Vector3i corners = mesh.triangles.col(t);
    const Eigen::Vector3d corner[3] = {mesh.vertices.col(corners[0]), mesh.vertices.col(corners[1]),
                                       mesh.vertices.col(corners[2])};
    const Eigen::Vector3d n =
        (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();  // outward
    if (-n.dot(n_O) < kCosine) continue;
    if (distance_to_triangle(p_O, corner, n) <= tolerance) return true;
  }
  return false;
}

}  // namespace

Eigen::Vector3d Examination::center(const FingerState& finger) const {
  return finger.p_OC - problem_.fingers.radius * finger.n_O;
}

/// Follows the contact of each finger through all rows. It may change in a regrasp only.
void Examination::check_fingers() {
  const auto count = static_cast<std::size_t>(problem_.fingers.count);
  std::vector<std::optional<FingerState>> held(count);
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) {
    if (is_regrasp(s)) held[segment(s).finger].reset();
    for (std::size_t r = 0; r < segment(s).rows.size(); ++r) {
      for (std::size_t i = 0; i < count; ++i) {
        const FingerState& finger = segment(s).rows[r].fingers[i];
        if (!finger.touches) continue;
        if (held[i] && is_same_contact(*held[i], finger, same_length_)) continue;
        if (held[i]) {
          fault(place(s, r), "finger " + std::to_string(i) + " has moved without a regrasp");
        }
        check_contact(s, r, i);
        held[i] = finger;
      }
    }
  }
}

/// Compares the first row with fingers.start.
void Examination::check_start() {
  const std::vector<Eigen::Vector3d>& start = problem_.fingers.start;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const FingerState& finger = segment(0).rows.front().fingers[i];
    if (finger.touches && (finger.p_OC - start[i]).norm() <= kStartTolerance) continue;
    fault(place(0, 0),
          "finger " + std::to_string(i) + " does not start where fingers.start has it");
  }
}

void Examination::check_contact(std::size_t s, std::size_t r, std::size_t i) {
  const FingerState& finger = segment(s).rows[r].fingers[i];
  const std::string who = "finger " + std::to_string(i);
  if (is_on_surface(problem_.object.mesh(), finger.p_OC, finger.n_O, same_length_)) return;
  fault(place(s, r), who + ": contact: not on the object's surface with that normal into it");
}

/// Object, obstacles and spheres of one radius.
struct Examination::World {
  World(const Problem& problem, double radius) {
    object = world.add_body("the object", problem.object.solid());
    for (const Obstacle& obstacle : problem.obstacles) {
      const int body = world.add_body("obstacle '" + obstacle.label() + "'", obstacle.solid());
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

/// Largest distance of a sphere's path from the chord between the two poses of an arc.
double Examination::bulge(std::size_t s, std::size_t arc) const {
  const Vector6d twist = arc_twist(s, arc);
  double most = 0;
  for (const FingerState& finger : segment(s).rows[0].fingers) {
    const Eigen::Vector3d way = twist.head<3>() + twist.tail<3>().cross(center(finger));
    most = std::max(most, way.norm() * twist.tail<3>().norm() / 8);
  }
  return most;
}

void Examination::check_clearances() {
  World at_poses(problem_, (1 - kSkin) * problem_.fingers.radius);
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) {
    for (std::size_t k = 0; k < segment(s).X_WO.size(); ++k) {
      const std::string where = place(s) + ", pose " + std::to_string(k);
      check_spheres(where, segment(s).rows[0]);
      check_planes(where, segment(s).rows[0], segment(s).X_WO[k], 0);
      check_world(at_poses, where, segment(s).rows[0], segment(s).X_WO[k]);
    }
    if (s > 0 && is_regrasp(s) && is_regrasp(s - 1)) check_between_regrasps(at_poses, s);
  }
  check_arcs();
}

/// A sphere that is clear at two poses may still graze a flat side in between, by the bulge of its
/// path.
void Examination::check_arcs() {
  const double skin = kSkin * problem_.fingers.radius;
  const auto parts = static_cast<std::size_t>(options_.samples_per_arc);
  std::map<double, World> worlds;  // by what is left out of the radius, in whole skins
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) {
    for (std::size_t r = 0; r < segment(s).rows.size() && !is_regrasp(s); ++r) {
      const double slack = bulge(s, r / parts);
      const double skins = std::min(1 + std::ceil(slack / skin - 1e-6), 1 / kSkin - 1);
      World& world =
          worlds.try_emplace(skins, problem_, problem_.fingers.radius - skins * skin).first->second;
      check_planes(place(s, r), segment(s).rows[r], row_pose(s, r), slack);
      check_world(world, place(s, r), segment(s).rows[r], row_pose(s, r));
      if (!problem_.obstacles.empty() && r % parts == 0) check_between_rows(world, s, r / parts);
    }
  }
}

/// Looks at obstacles between the rows of an arc: no fingertip moves by more than half its radius,
/// nor any point of the object by more than a fiftieth of its size, from one look to the next.
void Examination::check_between_rows(World& world, std::size_t s, std::size_t arc) {
  const Vector6d twist_O = arc_twist(s, arc);
  const auto way = [&](const Eigen::Vector3d& p_O) {
    return (twist_O.head<3>() + twist_O.tail<3>().cross(p_O)).norm();
  };
  const auto parts = static_cast<std::size_t>(options_.samples_per_arc);
  const Row& row = segment(s).rows[arc * parts];
  double looks = 0;
  for (const FingerState& finger : row.fingers) {
    looks = std::max(looks, way(center(finger)) / (0.5 * problem_.fingers.radius));
  }
  for (const auto& vertex : problem_.object.hull().colwise()) {
    looks = std::max(looks, way(vertex) / (0.02 * problem_.object.size()));
  }
  const int count = static_cast<int>(std::ceil(std::min(looks, kMostLooks)));
  const std::size_t known = faults_.size();
  for (int i = 1; i < count && faults_.size() == known; ++i) {
    const double t = static_cast<double>(i) / count;
    const auto r = arc * parts + static_cast<std::size_t>(t * static_cast<double>(parts));
    check_world(world, place(s, r) + " or beside it", row,
                along_screw(segment(s).X_WO[arc], twist_O, t));
  }
}

/// Checks the grip between two regrasps at one pose. All fingers are on the object then: the first
/// one to move is at its new place, the second at its old one.
void Examination::check_between_regrasps(World& world, std::size_t s) {
  const auto first = static_cast<std::size_t>(segment(s - 1).finger);
  const auto second = static_cast<std::size_t>(segment(s).finger);
  const std::string where = place(s) + ", before it";
  if (first == second) {
    return fault(where, "finger " + std::to_string(first) + " regrasps twice on end");
  }
  Row between = segment(s).rows[0];
  between.fingers[second] = segment(s - 1).rows[0].fingers[second];
  check_spheres(where, between);
  check_planes(where, between, segment(s).X_WO[0], 0);
  check_world(world, where, between, segment(s).X_WO[0]);
}

/// Checks that fingertips are above the planes, or less than `slack` [m] below.
void Examination::check_planes(const std::string& where, const Row& row,
                               const Eigen::Isometry3d& X_WO, double slack) {
  for (std::size_t i = 0; i < row.fingers.size(); ++i) {
    if (!row.fingers[i].touches) continue;
    const Eigen::Vector3d center_W = X_WO * center(row.fingers[i]);
    for (const Plane& plane : problem_.planes) {
      const double depth =
          problem_.fingers.radius - (plane.n_W.normalized().dot(center_W) - plane.offset);
      if (depth <= slack + same_length_) continue;
      fault(where, "finger " + std::to_string(i) + " reaches " + figure(depth) + " m into plane '" +
                       plane.name + "'");
    }
  }
}

/// Checks that fingertips are apart from each other, but not too far.
void Examination::check_spheres(const std::string& where, const Row& row) {
  const double radius = problem_.fingers.radius;
  for (std::size_t i = 0; i < row.fingers.size(); ++i) {
    const std::string who = "finger " + std::to_string(i);
    for (std::size_t j = 0; j < i; ++j) {
      if (!row.fingers[i].touches || !row.fingers[j].touches) continue;
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
  const auto is_lifted = [&](int body) {
    const int finger = body - world.fingers[0];
    return finger >= 0 && !row.fingers[finger].touches;
  };
  for (const auto& [a, b] : world.world.all_collisions()) {
    if (is_lifted(a) || is_lifted(b)) continue;
    fault(where, world.world.name(b) + " touches " + world.world.name(a));
  }
}

}  // namespace graspless::fingertip::checking
