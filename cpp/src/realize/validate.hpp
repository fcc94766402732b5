// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/realize/realize.hpp"

namespace graspless::realize {

// The plan's and the public API's types are those of fingertip.
using fingertip::Carrier;
using fingertip::FingerState;
using fingertip::JointSegment;
using fingertip::Obstacle;
using fingertip::Plan;
using fingertip::Plane;
using fingertip::Problem;
using fingertip::Realization;
using fingertip::RealizeOptions;
using fingertip::Row;
using fingertip::Segment;

/// Largest depth to which the links of a touching fingertip may reach into the object along the
/// contact's normal [m]. The tolerance on positions and rounding need as much.
inline double contact_allowance(double position_tolerance) { return 2 * position_tolerance + 1e-4; }

/// Throws std::invalid_argument on options that are not positive, fingertips or links that the
/// robot does not have or that no joint moves, or a plan that is not solved or has not the shape
/// that its header says.
void validate_realization(const Problem& problem, const Plan& plan, const robot::Robot& robot,
                          const Carrier& carrier, const RealizeOptions& options);

}  // namespace graspless::realize
