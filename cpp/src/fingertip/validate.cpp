// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a caller may not ask for.
#include "fingertip/validate.hpp"

#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "fingertip/model/clearance.hpp"
#include "fingertip/model/locations.hpp"
#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {
namespace {

void require(bool holds, const std::string& field, double value, const std::string& must) {
  if (holds) return;
  std::ostringstream text;
  text << field << " " << must << ", not " << value;
  throw std::invalid_argument(text.str());
}

void require_positive(const std::string& field, double value) {
  require(value > 0 && std::isfinite(value), field, value, "must be positive and finite");
}

// Beyond this the kernels' arithmetic would overflow.
constexpr double kLargest = 1e9;

void require_moderate(const std::string& field, double value) {
  require_positive(field, value);
  require(value <= kLargest, field, value, "must be at most 1e9");
}

void check_friction(const std::string& field, const FrictionInterval& friction) {
  require_moderate(field + ".lower", friction.lower);
  require_moderate(field + ".upper", friction.upper);
  require(friction.lower <= friction.upper, field + ".lower", friction.lower,
          "must not exceed " + field + ".upper = " + std::to_string(friction.upper));
}

void check_fingers(const Fingers& fingers) {
  require(fingers.count >= 1 && fingers.count <= mechanics::kMaxFingers, "fingers.count",
          fingers.count, "must be 1 to " + std::to_string(mechanics::kMaxFingers));
  require(fingers.radius > 0 && fingers.radius <= geometry::kMaxLength, "fingers.radius",
          fingers.radius, "must lie in (0, 1e4] m");
  require_moderate("fingers.max_normal_force", fingers.max_normal_force);
  check_friction("fingers.friction", fingers.friction);
  require(fingers.max_span >= 2 * fingers.radius, "fingers.max_span", fingers.max_span,
          "must be at least two radii (infinity: any)");
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
  }
}

void check_lattice_options(const Problem& problem, const Options& options, double locations) {
  if (!std::holds_alternative<Lattice>(problem.motion)) return;
  const double bytes = lattice_memory(problem, locations);
  if (bytes <= options.max_memory) return;
  std::ostringstream text;
  text << "motion.counts: the lattice would need " << bytes / 1e9
       << " GB, more than options.max_memory = " << options.max_memory / 1e9 << " GB";
  throw std::invalid_argument(text.str());
}

}  // namespace

void validate(const Problem& problem) {
  check_fingers(problem.fingers);
  check_friction("friction", problem.friction);
  check_planes(problem.planes);
  collision::require_obstacles(problem.obstacles);
  if (!problem.gravity_W.allFinite()) throw std::invalid_argument("gravity_W must be finite");
  require(problem.gravity_W.cwiseAbs().maxCoeff() <= kLargest, "gravity_W",
          problem.gravity_W.cwiseAbs().maxCoeff(), "must lie within 1e9 m/s^2");
  require_moderate("object.mass", problem.object.mass());
  check_motion(problem);
}

void validate(const Options& o) {
  planning::require_in_range("options.", o);
  require_positive("options.compliance.environment_normal", o.compliance.environment_normal);
  require_positive("options.compliance.environment_tangential",
                   o.compliance.environment_tangential);
  require_positive("options.compliance.finger_normal", o.compliance.finger_normal);
  require_positive("options.compliance.finger_tangential", o.compliance.finger_tangential);
  mechanics::StabilitySolver positively_spanning(o.disturbance_directions);
}

void validate(const Problem& problem, const Options& options) {
  validate(problem);
  validate(options);
  const double locations = num_grid_points(problem.object, options);
  check_lattice_options(problem, options, locations);
  const double bytes = memory_needed(problem, options, locations);
  if (bytes <= options.max_memory) return;
  std::ostringstream text;
  text << "options: " << locations << " fingertip locations for " << problem.fingers.count
       << " fingers need " << std::ceil(bytes / 1e6)
       << " MB, more than options.max_memory = " << options.max_memory / 1e6
       << " MB: take a smaller locations_per_side or a larger location_spacing";
  throw std::invalid_argument(text.str());
}

std::string to_string(Status status) { return planning::name_of(status); }

}  // namespace graspless::fingertip
