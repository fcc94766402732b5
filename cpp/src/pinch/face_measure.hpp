// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faces around the contacts of a pinch, as the planner and check() measure them.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "graspless/geometry/polygon.hpp"

namespace graspless::pinch {

/// Returns the steepest slope of an outline around a contact, of the lines that fit best 4 mm to
/// each side of it, and both: its tangent to the face, which `outward` [2] is normal to. Nothing if
/// there is no outline.
std::optional<double> steepest_around(const geometry::Polygon& outline,
                                      const Eigen::Vector2d& contact,
                                      const Eigen::Vector2d& outward);

/// Returns the least coefficient of friction that may hold a pad on a slope that was measured.
double least_friction(double slope);

/// Returns true if a coefficient of friction holds a pad on a slope that was measured.
bool is_held(double slope, double friction);

}  // namespace graspless::pinch
