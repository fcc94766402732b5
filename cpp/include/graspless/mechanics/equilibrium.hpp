// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

/// Contact forces that balance a contact set, deep inside their cones and limits.
struct Equilibrium {
  Eigen::Matrix3Xd contact_forces_O;  ///< on the object, one a contact [N]
  Eigen::Matrix3Xd finger_forces_O;   ///< on the object, one a finger [N]
  /// The largest t such that all cone coefficients can be at least t, and t is left to the limits
  /// of fingers in position control [N].
  double margin = 0;
};

/// The interior equilibrium under no disturbance, with fingers in force control at their commanded
/// normal forces (entries of the others are not looked at): of all that have nine tenths of the
/// largest margin there is, the one whose coefficients beyond that have the least squares. It is
/// one answer, and follows the contacts continuously; the deepest equilibria themselves are many.
/// Where the environment alone can jam, margins have no limit: the sum of the known force and all
/// force limits then counts as the largest. Nothing when there is no equilibrium. Throws
/// std::invalid_argument on a bad contact set, modes or forces.
GRASPLESS_API std::optional<Equilibrium> interior_equilibrium(
    const ContactSet& set, const std::vector<FingerMode>& modes,
    const Eigen::VectorXd& commanded_forces);

/// Springs at the contacts, only whose ratios matter to compliant_stability(). Along the surface a
/// contact of elastic bodies is 2 (1 - nu) / (2 - nu) times as stiff as along its normal (Mindlin):
/// 0.8 for most materials. A finger is as stiff as the servo behind it, in all directions alike,
/// and that is softer than a floor; five times is a guess.
struct Compliance {
  double environment_normal = 1;        ///< stiffness along the normal [any unit of N/m]
  double environment_tangential = 0.8;  ///< along the surface, of contacts that stick
  double finger_normal = 0.2;           ///< of fingers in position control
  double finger_tangential = 0.2;
};

/// A margin that does not assume that passive friction redistributes freely. Each contact is a
/// spring about its nominal force: sticking contacts in all directions, sliding ones along the
/// normal (friction follows it), fingers in position control in all directions, fingers in force
/// control along the surface alone. The object moves until the springs balance a disturbance; the
/// index is the largest t [N] such that for all directions l_i the disturbance t l_i leaves every
/// contact pressing, within Coulomb's cone, and every finger within its limit. 0 where the springs
/// do not hold the object.
GRASPLESS_API double compliant_stability(const ContactSet& set,
                                         const std::vector<FingerMode>& modes,
                                         const Equilibrium& nominal,
                                         const Compliance& compliance = {},
                                         const Matrix6Xd& directions = disturbance_directions());

/// As interior_equilibrium(), with the room where the springs of compliant_stability() will ask for
/// it, so that this index is as large as can be: the cone of every contact moves inwards, by what a
/// disturbance may take from its force, and the largest disturbance that leaves an equilibrium is
/// looked for; once more along the forces found. (Commonly within a tenth of the best forces there
/// are; a quarter below has been seen, and in 3 of 1000 random sets less than even margins give.)
/// In cones of at least 12 edges, to which `margin` refers. Where the springs do not hold the
/// object all coefficients count alike. Throws as those two.
GRASPLESS_API std::optional<Equilibrium> compliant_equilibrium(
    const ContactSet& set, const std::vector<FingerMode>& modes,
    const Eigen::VectorXd& commanded_forces, const Compliance& compliance = {},
    const Matrix6Xd& directions = disturbance_directions());

}  // namespace graspless::mechanics
