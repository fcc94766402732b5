// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "pinch/check_contacts.hpp"
#include "robot/names.hpp"
#include "robot/rates.hpp"
#include "text.hpp"

namespace graspless::pinch {

using Eigen::Vector3d;

namespace {

constexpr double kMotorShare = 0.5;  // of the effort limit of a joint that grips
constexpr double kStill = 1e-3;      // of the fingers' motion per unit of a joint [m/rad or 1]
constexpr double kWeight = 9.81;     // of a kilogram [N]
constexpr double kMeasured = 0.15;   // of masses, relative
constexpr double kHangs = 0.1;       // of an object that hangs from the hand [rad]

/// Half length of the contact of a pad with the face of a prism: the pad ends with the finger, the
/// face with the object [m].
double pad_on_prism(const Problem& problem, const Plan& plan, const Options& options) {
  const robot::Robot& robot = problem.robot;
  robot::Poses X_WL;
  robot.forward(plan.segments.back().positions.back(), X_WL);
  const Vector3d down = -problem.support.normal_W();
  double lowest = -std::numeric_limits<double>::infinity();
  for (const bool sliding : {false, true})
    lowest = std::max(lowest, foremost(problem, X_WL, down, sliding).extent);
  const double height = plan.contacts_O(2, 0),
               below = lowest - down.dot(problem.X_WO_start * plan.contacts_O.col(0));
  return std::min({options.patch, below, height, problem.object.thickness() - height});
}

}  // namespace

Foremost foremost(const Problem& problem, const robot::Poses& X_WL, const Vector3d& d_W,
                  bool sliding) {
  Foremost found;
  for (const robot::LinkShape& shape : problem.robot.shapes()) {
    const auto link = static_cast<std::size_t>(shape.link);
    const std::string& name = problem.robot.frame_names()[link];
    if (!robot::contains(problem.hand.fingers, name) ||
        robot::contains(problem.hand.sliding_finger, name) != sliding)
      continue;
    const double extent = d_W.dot(X_WL[link].translation()) +
                          geometry::extent(shape.placed, X_WL[link].linear().transpose() * d_W);
    if (extent > found.extent) found = {shape.link, extent};
  }
  return found;
}

std::optional<double> finger_force(const Problem& problem, const Plan& plan,
                                   const Options& options) {
  if (options.grip_force) return options.grip_force;
  const robot::Robot& robot = problem.robot;
  robot::Poses X_WL;
  robot.forward(plan.segments.back().positions.back(), X_WL);
  const Eigen::Matrix3Xd p_W = problem.X_WO_start * plan.contacts_O;
  const Vector3d across = (p_W.col(1) - p_W.col(0)).normalized();
  const auto reach = [&](const Vector3d& d_W) { return foremost(problem, X_WL, d_W, true).extent; };
  const bool is_second = reach(across) - reach(-across) > across.dot(p_W.col(0) + p_W.col(1));
  Eigen::RowVectorXd closing = Eigen::RowVectorXd::Zero(robot.dof());  // [m/rad or 1]
  for (const int side : {0, 1}) {
    const Vector3d inward = side == 0 ? across : Vector3d(-across);
    const int link = foremost(problem, X_WL, inward, (side == 1) == is_second).link;
    closing += robot::rates(robot, link, X_WL, p_W.col(side), inward);
  }
  for (const int joint : robot.group(problem.hand.arm)) closing[joint] = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index j = 0; j < closing.size(); ++j) {
    const double rate = std::abs(closing[j]), limit = robot.max_effort()[j];
    if (rate < kStill) continue;
    if (!std::isfinite(limit)) return std::nullopt;
    least = std::min(least, kMotorShare * limit / rate);
  }
  return std::isfinite(least) ? least : 0;
}

/// The pads bear force, twist and tilt: see largest_mass().
std::vector<std::string> faults_of_load(const Problem& problem, const Plan& plan,
                                        const Options& options, double friction, double rise) {
  const bool is_wall = problem.object.heights().has_value();
  const std::optional<double> press = finger_force(problem, plan, options);
  if (!press) {
    if (!is_wall && !plan.max_mass) return {};  // nothing is said about the load
    return {"the effort limit of a joint that closes the hand is unknown"};
  }
  const Vector3d a = plan.contacts_O.col(0), b = plan.contacts_O.col(1),
                 line = (b - a).normalized(),
                 down = problem.X_WO_start.linear().transpose() * -Vector3d::UnitZ(),
                 arm = problem.object.com() - (a + b) / 2;
  const double mass = problem.object.mass(), weight = kWeight * mass, width = (b - a).norm(),
               mu = problem.hand.pad_friction, swing = kHangs * std::max(0.0, arm.dot(down)),
               patch = is_wall ? options.patch : pad_on_prism(problem, plan, options);
  const double left = mu - friction, half = patch - rise;
  const double along = std::max(0.0, std::abs(arm.cross(down).dot(line)) - swing),
               aside = arm.cross(down).cross(line).norm(),
               between = is_wall ? 0 : std::min(aside, width / 2),
               across = std::max(0.0, aside - between - swing);
  if (left <= 0 || (half <= 0 && across > 0)) {
    return {left <= 0 ? "its slopes need all friction of the pads"
                      : "nobody saw a face as low as the pads reach"};
  }
  const double slips = weight * (0.5 + between / width) / (left * *press),
               twists = along > 0 ? weight * along / (4 * mu * patch * *press / 3) : 0,
               tilts = across > 0 ? weight * across / (2 * half * *press) : 0;
  const double load = std::max(std::hypot(slips, twists), tilts), bears = mass / load;
  std::vector<std::string> faults;
  if (!(load <= 1 + kMeasured)) {
    faults.push_back("the pads bear " + figure(bears) + " kg there, it weighs " + figure(mass) +
                     " kg");
  }
  if (is_wall && !plan.max_mass) faults.push_back("max_mass is missing");
  if (plan.max_mass && !(*plan.max_mass > 0 && *plan.max_mass <= (1 + kMeasured) * bears))
    faults.push_back("max_mass must be above 0 and at most the " + figure(bears) +
                     " kg that the pads bear");
  return faults;
}

}  // namespace graspless::pinch
