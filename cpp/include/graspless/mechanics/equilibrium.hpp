// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/mechanics/contact.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::mechanics {

/// Contact forces that balance a contact set, well inside their cones and limits.
struct Equilibrium {
  Eigen::Matrix3Xd contact_forces_O;  ///< force on the object at each contact [N]
  Eigen::Matrix3Xd finger_forces_O;   ///< force on the object at each finger [N]
  /// Largest t such that all cone coefficients are at least t, and fingers in position control stay
  /// at least t below their limits [N].
  double margin = 0;
};

/// Interior equilibrium without disturbance. Fingers in force control press with their commanded
/// normal forces; entries for the other fingers are ignored. Among all equilibria with at least 0.9
/// of the largest possible margin, it is the one whose cone coefficients beyond that margin have
/// the least sum of squares. That makes the answer unique and continuous in the contacts;
/// equilibria of largest margin are not unique. If the environment alone can jam, margins have no
/// limit, and the sum of the known force and all force limits counts as the largest margin. Returns
/// nothing if there is no equilibrium. Throws std::invalid_argument on a bad contact set, modes or
/// forces.
GRASPLESS_API std::optional<Equilibrium> interior_equilibrium(
    const ContactSet& set, const std::vector<FingerMode>& modes,
    const Eigen::VectorXd& commanded_forces);

/// Stiffness of the springs that model the contacts. Only ratios matter to compliant_stability();
/// withstands() also limits how far the object yields.
/// Along the surface, a contact of elastic bodies is 2 (1 - nu) / (2 - nu) times as stiff as along
/// its normal (Mindlin), 0.8 for most materials. A finger is as stiff as its servo, alike in all
/// directions, and softer than a floor; the defaults are those of the fingers in the simulation and
/// a floor five times as stiff, which is a guess. fields() describes the members.
struct Compliance {
  double environment_normal = 5e4;
  double environment_tangential = 4e4;
  double finger_normal = 1e4;
  double finger_tangential = 1e4;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Compliance&) {
  using planning::Field, planning::Range;
  constexpr Range kStiffness = Range::closed(1e-9, 1e9);
  return std::make_tuple(
      Field{"environment_normal", &Compliance::environment_normal, "N/m",
            "Stiffness of contacts with the environment along the normal.", kStiffness},
      Field{"environment_tangential", &Compliance::environment_tangential, "N/m",
            "Stiffness of sticking contacts with the environment along the surface.", kStiffness},
      Field{"finger_normal", &Compliance::finger_normal, "N/m",
            "Stiffness of fingers in position control along the normal.", kStiffness},
      Field{"finger_tangential", &Compliance::finger_tangential, "N/m",
            "Stiffness of all fingers along the surface.", kStiffness});
}

/// Stability margin that does not assume that passive friction redistributes freely. Each contact
/// is a spring about its nominal force: sticking contacts in all directions, sliding contacts along
/// the normal (friction follows it), fingers in position control in all directions, and fingers in
/// force control along the surface only. The object moves until the springs balance a disturbance.
/// The margin is the largest t [N] such that, for every direction l_i, the disturbance t l_i leaves
/// every contact pressing, every force within Coulomb's cone, and every finger within its limit.
/// Returns 0 if the springs do not hold the object. Throws std::invalid_argument on bad arguments.
GRASPLESS_API double compliant_stability(const ContactSet& set,
                                         const std::vector<FingerMode>& modes,
                                         const Equilibrium& nominal,
                                         const Compliance& compliance = {},
                                         const Matrix6Xd& directions = disturbance_directions());

/// Equilibrium whose compliant_stability() is as large as possible. Like interior_equilibrium(),
/// but the reserve of each contact is what a disturbance may take from its force: the cones move
/// inwards by it, and the largest disturbance that leaves an equilibrium is sought, twice, the
/// second time along the forces found first. Commonly the margin is within a tenth of the best
/// possible one; a quarter below has been seen, and in 3 of 1000 random sets it is less than that
/// of interior_equilibrium(). Cones have at least 12 edges, to which `margin` refers. If the
/// springs do not hold the object, all coefficients count alike. Throws std::invalid_argument like
/// interior_equilibrium() and compliant_stability().
GRASPLESS_API std::optional<Equilibrium> compliant_equilibrium(
    const ContactSet& set, const std::vector<FingerMode>& modes,
    const Eigen::VectorXd& commanded_forces, const Compliance& compliance = {},
    const Matrix6Xd& directions = disturbance_directions());

}  // namespace graspless::mechanics
