// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "graspless/robot/robot.hpp"

namespace graspless::slide {

constexpr double kRowStep = 0.05;  // largest Robot::step() between rows of a plan [rad]

/// Number of equal steps in which a straight motion is checked: rows of kRowStep, each divided at
/// `resolution`. check() replays the plan at the same configurations, so that no collision hides
/// between two grids.
inline int replay_steps(double span, double resolution) {
  const double rows = std::max(1.0, std::ceil(span / kRowStep));
  return static_cast<int>(rows * std::max(1.0, std::ceil(span / rows / resolution)));
}

/// Length of such a step [rad].
inline double replay_step(const robot::Robot& robot, const Eigen::VectorXd& from,
                          const Eigen::VectorXd& to, double resolution) {
  const double span = robot.step(from, to);
  if (span == 0) return resolution;
  constexpr double kRounding = 1 + 1e-12;
  return span / replay_steps(span, resolution) * kRounding;
}

}  // namespace graspless::slide
