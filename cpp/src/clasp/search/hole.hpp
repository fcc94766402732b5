// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "graspless/clasp/problem.hpp"

namespace graspless::clasp {

/// Width of the hole that a loop runs around [m]: the diameter of the largest ball that fits onto
/// the cone over the loop without touching the object. Whatever passes through the hole crosses
/// this cone, so no wider ball does. Correct to 0.5 mm, never too small. Stops early at a width of
/// `enough` [m].
double hole_width(const Object& object, int loop, double enough);

/// Centre of the largest ball that fits onto the cone over a loop, and its diameter.
struct Hole {
  Eigen::Vector3d center_O;
  double width;  ///< [m]
};
Hole widest_place(const Object& object, int loop);

/// Width that a hole must have [m]: the thumb, or all fingers one by one, must pass. Twice the
/// radius of their tips; 0 if the tips have no shape.
double needed_width(const robot::Robot& robot, const Hand& hand);

/// Widths of a loop's hole, its handle and what must pass, for the reason of a failed search.
std::string describe_sizes(const Problem& problem, int loop);

}  // namespace graspless::clasp
