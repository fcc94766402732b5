// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fingertip plans that go on from where the object was measured.
#pragma once

#include "graspless/fingertip/fingertip.hpp"

namespace graspless::fingertip {

/// Largest distances of a measured object from the poses of the segment under way.
constexpr double kMaxAside = 0.02;    ///< of the centre of mass, along the floor or off it [m]
constexpr double kMaxTurned = 0.175;  ///< about any axis, 10 degrees [rad]

/// The rest of a plan, as a problem of its own.
struct Rest {
  Problem problem;
  Plan plan;  ///< for `problem`, which check() needs
};

/// Plans the rest of a plan from a measured pose of the object, with the fingers where they are.
///
/// The object is taken to be at the nearest pose of `segment`, moved along the floor and turned
/// about its normal as measured. Where the object cannot be there because it would leave a wall or
/// enter it, it is taken to be at the pose itself, and a warning says how far that is from the
/// measurement. From there the object goes on through the poses of the plan. A finger that regrasps
/// is taken to be at its new place.
///
/// A state from which the plan does not go on is a status: off_path (more than kMaxAside or
/// kMaxTurned from all poses of the segment), at_goal, or one of plan(). Throws
/// std::invalid_argument if the problem, the options or the budget is bad, the plan is not solved
/// or not one for the problem, there is no such segment, or X_WO is not a pose.
GRASPLESS_API Rest resume(const Problem& problem, const Plan& plan, int segment,
                          const Eigen::Isometry3d& X_WO, const Options& options = {},
                          const planning::Budget& budget = {});

}  // namespace graspless::fingertip
