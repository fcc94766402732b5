// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "graspless/mechanics/equilibrium.hpp"

namespace graspless::mechanics {

/// Reserve that a contact or finger keeps, per unit of t.
struct Reserve {
  Eigen::Vector3d apex_O;  ///< the force stays within the cone whose apex is at t times this
  double normal = 0;       ///< a finger in position control stays t times this below its limit
};

/// Contact forces that balance a set with at least the fraction `kept` of the largest possible t.
/// Among these, the coefficients beyond the reserves have the least sum of squares. t is at most
/// `t_max`. `reserves` holds those of the contacts, then those of the fingers. Returns nothing if
/// there is no equilibrium.
std::optional<Equilibrium> inner_forces(const ContactSet& set, const std::vector<FingerMode>& modes,
                                        const Eigen::VectorXd& commanded_forces,
                                        const std::vector<Reserve>& reserves, double t_max,
                                        double kept);

/// Largest useful force [N]: the known force plus all force limits. It bounds t, which would
/// otherwise be unbounded where the environment alone can jam.
double largest_force(const ContactSet& set);

}  // namespace graspless::mechanics
