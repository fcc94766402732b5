// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "graspless/mechanics/equilibrium.hpp"

namespace graspless::mechanics {

/// What a contact or finger is to keep in reserve, per unit of t.
struct Reserve {
  Eigen::Vector3d apex_O;  ///< its force stays within the cone that begins at t times this
  double normal = 0;       ///< a finger in position control: t times this below its limit
};

/// The contact forces that balance a set with the largest t, contacts' reserves before fingers'; of
/// all that have at least the share `kept` of it, those whose coefficients beyond have the least
/// squares. t is at most `t_max`. Nothing when there is no equilibrium.
std::optional<Equilibrium> inner_forces(const ContactSet& set, const std::vector<FingerMode>& modes,
                                        const Eigen::VectorXd& commanded_forces,
                                        const std::vector<Reserve>& reserves, double t_max,
                                        double kept);

/// t can grow without bound only where the environment alone can jam: no force that is asked for is
/// of use beyond this one: the known force and all force limits together.
double largest_force(const ContactSet& set);

}  // namespace graspless::mechanics
