// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where fingertips may press: placements as sets of locations, and the locations that the sphere
// can reach.
#include "fingertip/model/locations.hpp"

#include <algorithm>

#include "graspless/collision/world.hpp"

namespace graspless::fingertip {
namespace {

// The sphere is tested a little smaller, so as not to touch the face that it presses on; more than
// the collision checker's own uncertainty.
constexpr double kShrink = 1e-3;
constexpr double kMinShrink = 2e-6;  // [m]
constexpr double kSlack = 1e-9;      // by the object's size

/// Which locations' spheres touch the object nowhere else.
std::vector<Location> reachable(std::vector<Location> all, const Object& object, double radius) {
  if (object.is_convex()) return all;
  const double shrink = std::max(kShrink * radius, std::min(kMinShrink, radius / 2));
  collision::World world;
  const int body = world.add_body("object", object.solid());
  const int sphere = world.add_body(
      "fingertip", {{geometry::Sphere{radius - shrink}, Eigen::Isometry3d::Identity()}});
  world.add_pair(body, sphere);
  const auto touches = [&](const Location& location) {
    world.set_pose(sphere, Eigen::Isometry3d(Eigen::Translation3d(location.center_O)));
    return world.collides();
  };
  all.erase(std::remove_if(all.begin(), all.end(), touches), all.end());
  return all;
}

std::vector<mechanics::FingerWrenches> wrenches_of(const std::vector<Location>& all,
                                                   const Object& object, const Fingers& fingers,
                                                   const Options& options) {
  mechanics::ContactSet set;
  set.com_O = object.com();
  set.wrench_scale = mechanics::wrench_scale(object.mass(), object.inertia());
  set.cone_edges = options.cone_edges;
  set.fingers.resize(1);
  const auto at_friction = [&](double friction) {
    set.fingers[0].friction = friction;
    return mechanics::finger_wrenches(set, 0);
  };
  std::vector<mechanics::FingerWrenches> wrenches;
  wrenches.reserve(all.size());
  for (const Location& at : all) {
    set.fingers[0] = {at.p_OC, at.n_O, fingers.friction.lower, fingers.max_normal_force, at.t_O};
    wrenches.push_back(at_friction(fingers.friction.lower));
    if (fingers.friction.upper > fingers.friction.lower) {
      wrenches.back().jam_generators = at_friction(fingers.friction.upper).generators;
    }
  }
  return wrenches;
}

}  // namespace

int num_fingers(const Placement& placement) {
  int count = 0;
  while (count < mechanics::kMaxFingers && placement[static_cast<std::size_t>(count)] >= 0) ++count;
  return count;
}

Placement with(const Placement& placement, int location) {
  Placement result = placement;
  int i = num_fingers(placement);
  for (; i > 0 && result[static_cast<std::size_t>(i - 1)] > location; --i) {
    result[static_cast<std::size_t>(i)] = result[static_cast<std::size_t>(i - 1)];
  }
  result[static_cast<std::size_t>(i)] = location;
  return result;
}

Placement without(const Placement& placement, int location) {
  Placement result = kNoFingers;
  std::remove_copy(placement.begin(), placement.end(), result.begin(), location);
  return result;
}

Locations::Locations(const Object& object, const Fingers& fingers, const Options& options)
    : all_(reachable(grid_locations(object, fingers.radius, options), object, fingers.radius)),
      wrenches_(wrenches_of(all_, object, fingers, options)) {
  const double apart = 2 * fingers.radius - kSlack * object.size();
  const double span = fingers.max_span + kSlack * object.size();
  min_distance2_ = apart > 0 ? apart * apart : 0;
  max_distance2_ = span * span;
}

bool Locations::are_apart(int a, int b) const {
  const double distance2 = ((*this)[a].center_O - (*this)[b].center_O).squaredNorm();
  return distance2 >= min_distance2_ && distance2 <= max_distance2_;
}

}  // namespace graspless::fingertip
