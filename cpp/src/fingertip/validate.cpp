// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Validation of problems and options.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "fingertip/model/instants.hpp"
#include "fingertip/model/locations.hpp"
#include "fingertip/planner.hpp"
#include "text.hpp"

namespace graspless::fingertip {
namespace {

void check_friction(const std::string& field, const FrictionInterval& friction) {
  require_within(field + ".lower", friction.lower, 0, mechanics::kMaxFriction);
  require_within(field + ".upper", friction.upper, 0, mechanics::kMaxFriction);
  require(friction.lower <= friction.upper, field + ".lower", friction.lower,
          "must not exceed " + field + ".upper = " + figure(friction.upper));
}

void check_fingers(const Fingers& fingers) {
  require(fingers.count >= 1 && fingers.count <= mechanics::kMaxFingers, "fingers.count",
          fingers.count, "must be 1 to " + std::to_string(mechanics::kMaxFingers));
  require_within("fingers.radius", fingers.radius, geometry::kMinLength, geometry::kMaxLength,
                 " m");
  require_within("fingers.max_normal_force", fingers.max_normal_force, mechanics::kMinForce,
                 mechanics::kMaxForce, " N");
  check_friction("fingers.friction", fingers.friction);
  require(fingers.max_span >= 2 * fingers.radius, "fingers.max_span", fingers.max_span,
          "must be at least two radii (infinity: any)");
}

/// Refuses fingers at the start that are not on the object, or too near each other.
void check_start(const Problem& problem) {
  const std::vector<Eigen::Vector3d>& start = problem.fingers.start;
  if (start.empty()) return;
  require(static_cast<int>(start.size()) == problem.fingers.count, "fingers.start", start.size(),
          "must hold a place for each of " + std::to_string(problem.fingers.count) + " fingers");
  if (std::holds_alternative<Goal>(problem.motion)) {
    throw std::invalid_argument("fingers.start needs a Path or a Lattice, not a Goal");
  }
  std::vector<Location> places;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const std::string field = "fingers.start[" + std::to_string(i) + "]";
    if (!start[i].allFinite()) throw std::invalid_argument(field + " must be finite");
    const auto place = location_at(problem.object, problem.fingers.radius, start[i]);
    if (!place) {
      throw std::invalid_argument(field +
                                  " must lie on the object's surface to within 0.1 mm, "
                                  "where the sphere touches it nowhere else");
    }
    places.push_back(*place);
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = (places[i].center_O - places[j].center_O).norm();
      const double slack = 1e-6 * problem.object.size();
      require(distance >= 2 * problem.fingers.radius - slack &&
                  distance <= problem.fingers.max_span + slack,
              field, distance,
              "must be two radii to fingers.max_span from fingers.start[" + std::to_string(j) +
                  "], centre to centre");
    }
  }
}

void check_planes(const std::vector<Plane>& planes) {
  if (planes.empty()) {
    throw std::invalid_argument("planes must hold the floor at least, but is empty");
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const std::string field = "planes[" + std::to_string(i) + "] '" + planes[i].name + "'";
    require(std::abs(planes[i].n_W.norm() - 1) <= 1e-6, field + ".n_W", planes[i].n_W.norm(),
            "must be a unit vector: its length must be 1");
    require(std::abs(planes[i].offset) <= geometry::kMaxLength, field + ".offset", planes[i].offset,
            "must lie within 1e4 m");
    if (planes[i].friction) check_friction(field + ".friction", *planes[i].friction);
  }
}

void check_number_of_intervals(const Problem& problem) {
  const int count = num_intervals(problem);
  require(count <= mechanics::kMaxUncertainSurfaces, "friction and planes[i].friction", count,
          "must have lower < upper at most " + std::to_string(mechanics::kMaxUncertainSurfaces) +
              " times");
}

void check_weight(const Problem& problem) {
  const double mass = problem.object.mass(), gravity = problem.gravity_W.cwiseAbs().maxCoeff();
  if (!problem.gravity_W.allFinite()) throw std::invalid_argument("gravity_W must be finite");
  require_within("gravity_W", gravity, 0, mechanics::kMaxGravity, " m/s^2, along each axis");
  require_within("object.mass", mass, mechanics::kMinMass, mechanics::kMaxMass, " kg");
  require_within("weight of the object, object.mass times gravity_W", mass * gravity, 0,
                 mechanics::kMaxForce, " N");
}

}  // namespace

void validate(const Problem& problem) {
  check_fingers(problem.fingers);
  check_friction("friction", problem.friction);
  check_planes(problem.planes);
  check_number_of_intervals(problem);
  collision::require_obstacles(problem.obstacles);
  check_weight(problem);
  check_start(problem);
  check_motion(problem);
}

void validate(const Options& o) {
  planning::require_in_range("options.", o);
  planning::require_in_range("options.compliance.", o.compliance);
  mechanics::StabilitySolver positively_spanning(o.disturbance_directions);
}

void validate(const Problem& problem, const Options& options) {
  validate(problem);
  validate(options);
}

std::string to_string(Status status) { return planning::name_of(status); }

}  // namespace graspless::fingertip
