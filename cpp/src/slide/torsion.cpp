// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/torsion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "slide/contact.hpp"

namespace graspless::slide {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]

/// A row of the slide: what presses, and about where the object turns.
struct Moment {
  Eigen::Vector2d p_SC;  ///< centre of pressure [m]
  double yaw;            ///< of the object [rad]
  double radius;         ///< mean, of the object's points about the centre of pressure [m]
  double press;          ///< [N]
};

Moment moment(const Problem& problem, const Eigen::VectorXd& q, const Eigen::Isometry3d& X_WO) {
  const robot::Robot& robot = problem.robot;
  const Eigen::Isometry3d X_SW = problem.support.X_WS().inverse();
  const Tip pressing = tip(X_SW * robot.pose(robot.frame(problem.hand.fingertip), q));
  const Planar X_SO = planar(X_SW * X_WO);
  const double press =
      press_force(problem.hand, problem.object.thickness() - pressing.height, pressing.pitch);
  const double weight = problem.object.mass() * kGravity;
  const Eigen::Vector2d p_SC =
      (press * pressing.position + weight * (X_SO * problem.object.com().head<2>().eval())) /
      (press + weight);
  const Eigen::Vector2d p_OC = X_SO.inverse() * p_SC;
  const double radius = (problem.object.points().colwise() - p_OC).colwise().norm().mean();
  return {p_SC, std::atan2(X_SO.linear()(1, 0), X_SO.linear()(0, 0)), radius, press};
}

}  // namespace

double press_force(const Hand& hand, double depth, double pitch) {
  const double L = hand.flexure_length;
  const double flexed = std::asin(std::max(-1.0, std::sin(pitch) - depth / L));
  return std::max(0.0, hand.flexure_stiffness * (pitch - flexed) / (L * std::cos(flexed)));
}

double max_turn_per_length(const Problem& problem, double radius, double press) {
  const double grip = problem.hand.pad_friction * press;
  if (grip <= 0) return 0;
  const double drag =
      problem.support.friction() * (press + problem.object.mass() * kGravity) / grip;
  const double R = drag * drag, lever = 4 * radius / problem.hand.pad_width;
  if (R >= 1) return 0;
  const double excess = R * lever * lever - 1;
  if (excess <= 0) return std::numeric_limits<double>::infinity();
  return std::sqrt((1 - R) / excess) / radius;
}

Turning turning(const Problem& problem, const Plan& plan) {
  Turning found;
  const auto slide = std::find_if(plan.segments.begin(), plan.segments.end(),
                                  [](const Segment& segment) { return segment.name == "slide"; });
  if (problem.hand.finger_model == FingerModel::none || slide == plan.segments.end()) {
    found.allowed = std::numeric_limits<double>::infinity();
    return found;
  }
  found.allowed = std::numeric_limits<double>::infinity();
  Moment before = moment(problem, slide->positions.front(), slide->object_poses.front());
  for (std::size_t row = 1; row < slide->positions.size(); ++row) {
    const Moment now = moment(problem, slide->positions[row], slide->object_poses[row]);
    const double way = (now.p_SC - before.p_SC).norm();
    const double turn = std::abs(std::remainder(now.yaw - before.yaw, 2 * std::acos(-1.0)));
    const double allowed = max_turn_per_length(problem, now.radius, now.press);
    if (way > 0) found.most = std::max(found.most, turn / way);
    found.allowed = std::min(found.allowed, allowed);
    if (std::isfinite(allowed)) found.lag += std::max(0.0, turn - allowed * way);
    before = now;
  }
  return found;
}

}  // namespace graspless::slide
