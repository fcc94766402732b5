// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Validation of motions: paths, lattices and goals.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "graspless/geometry/pose.hpp"
#include "graspless/mechanics/contact_patch.hpp"
#include "graspless/watch.hpp"

#include "fingertip/goal/goal.hpp"
#include "fingertip/model/clearance.hpp"
#include "fingertip/model/instants.hpp"
#include "fingertip/model/screw.hpp"
#include "fingertip/planner.hpp"
#include "text.hpp"

namespace graspless::fingertip {
namespace {

using mechanics::Vector6d;

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
  refuse(where, "the object floats: it is " + figure(gap) + " m off the nearest plane");
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
  if (X_WO.size() < 2 || X_WO.size() > std::size_t{kMaxPoses}) {
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
    refuse(field, "lower " + figure(lower) + " must not exceed upper " + figure(upper));
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
    refuse(field, "the start (0) must be one of its values: lower " + figure(lower) + ", step " +
                      figure(step));
  }
  for (int turns = -2; turns <= 2; ++turns) {
    if (is_on(goal + turns * period)) return;
    if (period == 0) break;
  }
  refuse(field, "the goal (" + figure(goal) + ") must be one of its values: lower " +
                    figure(lower) + ", upper " + figure(upper) + ", step " + figure(step));
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
    check_axis(names[i], lattice.lower[i], lattice.upper[i], lattice.counts[i], goal[i], period[i]);
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
    refuse("motion." + field, "must be positive and finite, not " + figure(value));
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

}  // namespace

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

}  // namespace graspless::fingertip
