// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "graspless/slide/slide.hpp"

namespace graspless::slide {

/// How the fingers bear an object that they grasp at its edge, and then lift.
struct Bearing {
  double lever;     ///< distance of the centre of mass beyond the fingertips, 0 or more [m]
  double offset;    ///< distance of the centre of mass from the middle of the pads' width [m]
  double depth;     ///< length of the object between the fingers [m]
  double max_mass;  ///< that the hand's joints bear at three quarters of their effort limits [kg]
};

/// The lower finger bears the object at its tip, and the upper one presses it down at its edge.
/// With the weight W and pads of width w, the moments about both axes need
///
///   N_upper = W max(lever / depth, offset / w - 1/2),  N_lower = W + N_upper.
///
/// Both forces open the hand. Nothing if no joint resists them, or if the effort limit of one that
/// must is unknown, or a placeholder; or if the plan, which has all its segments, does not grasp.
std::optional<Bearing> bearing(const Problem& problem, const Plan& plan);

}  // namespace graspless::slide
