// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/robot/robot.hpp"

namespace graspless::scene {

/// What moves a body.
struct Carrier {
  int link = -1;     ///< frame index of the link it is rigid with; -1: it stands still
  double lever = 0;  ///< of an attached body: farthest point from the link's origin [m]; 0: a link
};

/// A bound on how far the bodies on carriers a and b move relative to one another, per unit of each
/// joint [m/rad or 1], over all configurations. Joints below the first link that both hang from
/// move them as one and do not count, unless `in_world`.
Eigen::VectorXd relative_reach(const robot::Robot& robot, const Carrier& a, const Carrier& b,
                               bool in_world);

/// What must be left of a distance for a stretch to count as free: more than rounding and FCL's
/// errors [m].
constexpr double kMargin = 1e-7;

/// In how many even steps of at most `resolution` in any joint a straight motion is looked at.
/// Throws std::invalid_argument on a resolution that is not positive or asks for more than any
/// motion needs.
int num_steps(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double resolution);

}  // namespace graspless::scene
