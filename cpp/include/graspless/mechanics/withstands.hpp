// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/mechanics/equilibrium.hpp"

namespace graspless::mechanics {

/// Points of the object, and the distance by which the springs may let them move.
struct Yield {
  Eigen::Matrix3Xd points_O;                                  ///< 3 x N [m]
  double distance = std::numeric_limits<double>::infinity();  ///< [m]
};

/// Largest t [N] such that the contacts withstand every disturbance t l_i, and so all their
/// convex combinations, among them every disturbance of size t. Unlike Problem (6), fingers cannot
/// choose their forces: they are springs about their nominal forces. A disturbance is withstood if
/// - the force of each finger stays within Coulomb's cone and its limit,
/// - the environment can supply the rest of the balance within Coulomb's cones (sliding contacts:
///   on the edges c' of Eq. (1)),
/// - no point of `yield` moves farther than its distance,
/// and that
/// - while no contact of the environment slips, be they springs of the given stiffness or rigid,
/// - or although the friction of the environment gives way: along the surface, it is as stiff as a
///   finger or a tenth of that, beside rigid normals.
/// Each of these sets of disturbances is convex, so that the l_i decide. The environment's forces
/// may be distributed freely among two contacts that stick or three and more that slide in one
/// direction; other sets keep the springs' own distribution, about the nominal forces. t is at most
/// the sum of the known force and all force limits. Returns 0 if the springs do not hold the
/// object. Throws std::invalid_argument on bad arguments.
GRASPLESS_API double withstands(const ContactSet& set, const std::vector<FingerMode>& modes,
                                const Equilibrium& nominal, const Compliance& compliance = {},
                                const Yield& yield = {},
                                const Matrix6Xd& directions = disturbance_directions());

/// Numbers that fingers as springs promise.
struct Promise {
  double withstands = 0;  ///< withstands() [N]
  /// The same conditions hold without a disturbance while every finger is out of its place,
  /// relative to the object, by up to this distance in any direction [m]; often by more, as the
  /// worst changes of all forces are taken to come together. In its place, a finger has its nominal
  /// force; out of it, its spring presses or pulls more. With errors of up to e, the contacts still
  /// withstand `withstands` (1 - e / place_tolerance): the conditions are convex in disturbance and
  /// errors together. kAnyPlace at most; 0 if `withstands` is 0.
  double place_tolerance = 0;
  static constexpr double kAnyPlace = 1;  ///< no error matters [m]
};

/// Both numbers. Arguments and exceptions are those of withstands().
GRASPLESS_API Promise promise(const ContactSet& set, const std::vector<FingerMode>& modes,
                              const Equilibrium& nominal, const Compliance& compliance = {},
                              const Yield& yield = {},
                              const Matrix6Xd& directions = disturbance_directions());

}  // namespace graspless::mechanics
