// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Validation of problems and options.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "graspless/geometry/pose.hpp"
#include "graspless/mechanics/contact_patch.hpp"
#include "graspless/watch.hpp"

#include "fingertip/goal/goal.hpp"
#include "fingertip/model/clearance.hpp"
#include "fingertip/model/instants.hpp"
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

using planning::Range;

void require_within(const std::string& field, double value, const Range& range,
                    const std::string& unit) {
  require(range.contains(value), field, value, "must lie in " + planning::to_string(range) + unit);
}

void check_friction(const std::string& field, const FrictionInterval& friction) {
  require_within(field + ".lower", friction.lower, Range::closed(0, mechanics::kMaxFriction), "");
  require_within(field + ".upper", friction.upper, Range::closed(0, mechanics::kMaxFriction), "");
  require(friction.lower <= friction.upper, field + ".lower", friction.lower,
          "must not exceed " + field + ".upper = " + std::to_string(friction.upper));
}

void check_fingers(const Fingers& fingers) {
  require(fingers.count >= 1 && fingers.count <= mechanics::kMaxFingers, "fingers.count",
          fingers.count, "must be 1 to " + std::to_string(mechanics::kMaxFingers));
  require_within("fingers.radius", fingers.radius,
                 Range::closed(geometry::kMinLength, geometry::kMaxLength), " m");
  require_within("fingers.max_normal_force", fingers.max_normal_force,
                 Range::closed(mechanics::kMinForce, mechanics::kMaxForce), " N");
  check_friction("fingers.friction", fingers.friction);
  require(fingers.max_span >= 2 * fingers.radius, "fingers.max_span", fingers.max_span,
          "must be at least two radii (infinity: any)");
}

/// Refuses fingers at the start that are not on the object, or too near each other.
void check_start(const Problem& problem) {
  const std::vector<Eigen::Vector3d>& start = problem.fingers.start;
  if (start.empty()) return;
  require(static_cast<int>(start.size()) == problem.fingers.count, "fingers.start",
          static_cast<double>(start.size()),
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

using mechanics::Vector6d;

constexpr std::size_t kMaxPoses = 100000;
constexpr double kOnLattice = 1e-6;
constexpr double kMaxLatticePoses = 1e9;  // they are counted by an int

[[noreturn]] void refuse(const std::string& where, const std::string& fault) {
  throw std::invalid_argument(where + ": " + fault);
}

/// Refuses states in which the object touches no plane, enters one, or has contacts that points
/// cannot represent.
void check_state(const Problem& problem, const mechanics::BodyState& state,
                 const std::string& where) {
  const auto patches = mechanics::contact_patches(problem.object.hull(), problem.object.com(),
                                                  contact_planes(problem), state,
                                                  kContactTolerance * problem.object.size());
  if (!patches.fault.empty()) refuse(where, patches.fault);
  if (!patches.contacts.empty()) return;
  double gap = std::numeric_limits<double>::infinity();
  for (const Plane& plane : problem.planes) {
    const Eigen::VectorXd heights = plane.n_W.transpose() * (state.X_WO * problem.object.hull());
    gap = std::min(gap, heights.minCoeff() - plane.offset);
  }
  if (gap < kContactTolerance * problem.object.size()) {
    refuse(where, "the object lifts off every plane");
  }
  refuse(where, "the object floats: it is " + std::to_string(gap) + " m off the nearest plane");
}

void check_standing(const Problem& problem, Clearance& clearance, const Eigen::Isometry3d& X_WO,
                    const std::string& where) {
  geometry::require_pose(X_WO, where);
  check_state(problem, resting_state(X_WO, Vector6d::Zero()), where);
  const std::string obstacle = clearance.obstacle_at(X_WO);
  if (!obstacle.empty()) refuse(where, "the object touches " + obstacle);
}

void check_path(const Problem& problem, Clearance& clearance, const Path& path) {
  const auto& X_WO = path.X_WO;
  if (X_WO.size() < 2 || X_WO.size() > kMaxPoses) {
    throw std::invalid_argument("motion.X_WO must have 2 to " + std::to_string(kMaxPoses) +
                                " poses, not " + std::to_string(X_WO.size()));
  }
  const auto at = [](std::size_t i) { return "motion.X_WO[" + std::to_string(i) + "]"; };
  check_standing(problem, clearance, X_WO[0], at(0));
  for (std::size_t i = 0; i + 1 < X_WO.size(); ++i) {
    poll();
    const std::string where = at(i) + " to the next";
    geometry::require_pose(X_WO[i + 1], at(i + 1));
    const Vector6d twist_O = screw_between(X_WO[i], X_WO[i + 1]);
    if (!(twist_O.norm() > 1e-9)) refuse(where, "must differ, but are the same pose");
    if (twist_O.tail<3>().norm() > kMaxTurn) {
      refuse(where, "turns by more than 3 rad: take more poses");
    }
    // The beginning of the motion first, where the reason is plainest.
    for (const double part : {0.0, 0.5}) {
      check_state(problem, moving_state(along_screw(X_WO[i], twist_O, part), twist_O), where);
    }
    check_standing(problem, clearance, X_WO[i + 1], at(i + 1));
    const std::string obstacle = clearance.obstacle_along(X_WO[i], twist_O);
    if (!obstacle.empty()) refuse(where, "the object touches " + obstacle + " on the way");
  }
}

/// Refuses axes of a lattice that make no sense or do not contain start and goal.
void check_axis(const std::string& name, double lower, double upper, int count, double goal,
                double period) {
  const std::string field = "motion: lattice along " + name;
  if (count < 1 || count > 100000) {
    refuse(field, "counts must be 1 to 100000, not " + std::to_string(count));
  }
  if (!(std::isfinite(lower) && std::isfinite(upper) && lower <= upper)) {
    refuse(field,
           "lower " + std::to_string(lower) + " must not exceed upper " + std::to_string(upper));
  }
  if ((count == 1) != (lower == upper)) {
    refuse(field, "one value needs lower = upper, more need lower < upper");
  }
  const double step = count > 1 ? (upper - lower) / (count - 1) : 1;
  const auto is_on = [&](double value) {
    const double index = (value - lower) / step;
    return std::abs(index - std::round(index)) * step <= kOnLattice && index > -0.5 &&
           index < count - 0.5;
  };
  if (!is_on(0)) {
    refuse(field, "the start (0) must be one of its values: lower " + std::to_string(lower) +
                      ", step " + std::to_string(step));
  }
  for (int turns = -2; turns <= 2; ++turns) {
    if (is_on(goal + turns * period)) return;
    if (period == 0) break;
  }
  refuse(field, "the goal (" + std::to_string(goal) + ") must be one of its values: lower " +
                    std::to_string(lower) + ", upper " + std::to_string(upper) + ", step " +
                    std::to_string(step));
}

void check_lattice(const Problem& problem, Clearance& clearance, const Lattice& lattice) {
  const auto& counts = lattice.counts;
  if (1.0 * counts[0] * counts[1] * counts[2] > kMaxLatticePoses) {
    refuse("motion.counts", "a lattice may have 1e9 poses at most");
  }
  check_standing(problem, clearance, lattice.X_WO_start, "motion.X_WO_start");
  check_standing(problem, clearance, lattice.X_WO_goal, "motion.X_WO_goal");
  const Eigen::Matrix3d turn = lattice.X_WO_goal.linear() * lattice.X_WO_start.linear().transpose();
  const Eigen::Vector3d& n_W = problem.planes.front().n_W;
  if (!n_W.isApprox(Eigen::Vector3d::UnitZ(), 1e-6)) {
    refuse("motion", "a lattice needs a level floor: planes[0].n_W = (0, 0, 1)");
  }
  if (!(turn * n_W).isApprox(n_W, kOnLattice)) {
    refuse("motion.X_WO_goal",
           "must stand on the same face as the start: a lattice does not tumble");
  }
  const Eigen::Vector3d p = lattice.X_WO_goal.translation() - lattice.X_WO_start.translation();
  const double yaw = std::atan2(turn(1, 0), turn(0, 0));
  const char* names[] = {"x", "y", "yaw"};
  const double goal[] = {p.x(), p.y(), yaw}, period[] = {0, 0, 2 * M_PI};
  for (int i = 0; i < 3; ++i) {
    check_axis(names[i], lattice.lower[i], lattice.upper[i],
               lattice.counts[static_cast<std::size_t>(i)], goal[i], period[i]);
  }
  const int yaws = counts[2];
  if (yaws > 1 && (lattice.upper[2] - lattice.lower[2]) / (yaws - 1) > kMaxTurn) {
    refuse("motion: lattice along yaw", "one step turns by more than 3 rad: take more values");
  }
  if (std::max({std::abs(p.x()), std::abs(p.y()), std::abs(yaw)}) <= kOnLattice) {
    refuse("motion.X_WO_goal", "must differ from the start");
  }
}

void check_goal(const Problem& problem, Clearance& clearance, const Goal& goal) {
  check_standing(problem, clearance, goal.X_WO_start, "motion.X_WO_start");
  check_standing(problem, clearance, goal.X_WO_goal, "motion.X_WO_goal");
  const auto require_step = [](const std::string& field, double value) {
    if (value > 0 && std::isfinite(value)) return;
    refuse("motion." + field, "must be positive and finite, not " + std::to_string(value));
  };
  require_step("slide_step", goal.slide_step);
  require_step("turn_step", goal.turn_step);
  if (goal.max_tumbles < 0 || goal.max_tumbles > 12) {
    refuse("motion.max_tumbles", "must be 0 to 12, not " + std::to_string(goal.max_tumbles));
  }
  const auto require_poses = [](const std::string& field, double amount, double step) {
    if (amount / step <= kMaxPoses) return;
    refuse("motion." + field, "may make " + std::to_string(kMaxPoses) +
                                  " poses at most, but is so small that it could make more");
  };
  const double distance = (goal.X_WO_goal.translation() - goal.X_WO_start.translation()).norm();
  const double rolled = 2 * problem.object.size() * (goal.max_tumbles + 1);
  require_poses("slide_step", distance + rolled, goal.slide_step);
  require_poses("turn_step", M_PI * (goal.max_tumbles + 1), goal.turn_step);
  const Eigen::Isometry3d X = goal.X_WO_start.inverse() * goal.X_WO_goal;
  if (X.linear().isIdentity(1e-9) && X.translation().norm() < 1e-9 * problem.object.size()) {
    refuse("motion.X_WO_goal", "must differ from the start");
  }
  const ContactStates states(problem.object);
  standing_face(problem, states, goal.X_WO_start, "motion.X_WO_start");
  standing_face(problem, states, goal.X_WO_goal, "motion.X_WO_goal");
}

void check_motion(const Problem& problem) {
  Clearance clearance(problem);
  if (const auto* path = std::get_if<Path>(&problem.motion)) {
    check_path(problem, clearance, *path);
  } else if (const auto* lattice = std::get_if<Lattice>(&problem.motion)) {
    check_lattice(problem, clearance, *lattice);
  } else {
    check_goal(problem, clearance, std::get<Goal>(problem.motion));
  }
}

void check_weight(const Problem& problem) {
  const double mass = problem.object.mass(), gravity = problem.gravity_W.cwiseAbs().maxCoeff();
  if (!problem.gravity_W.allFinite()) throw std::invalid_argument("gravity_W must be finite");
  require_within("gravity_W", gravity, Range::closed(0, mechanics::kMaxGravity),
                 " m/s^2, along each axis");
  require_within("object.mass", mass, Range::closed(mechanics::kMinMass, mechanics::kMaxMass),
                 " kg");
  require_within("weight of the object, object.mass times gravity_W", mass * gravity,
                 Range::closed(0, mechanics::kMaxForce), " N");
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
