// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "graspless/mechanics/equilibrium.hpp"
#include "graspless/mechanics/withstands.hpp"

namespace graspless::mechanics {

/// Contact as a spring about its nominal force.
struct GRASPLESS_API Spring {
  Eigen::Vector3d n;               ///< normal into the object, in O
  double friction = 0;             ///< coefficient
  double max_normal = kUnlimited;  ///< [N]
  bool follows = false;      ///< sliding contact: friction follows the normal force and cannot slip
  Eigen::Matrix3Xd changes;  ///< change of the force on the object per unit of each disturbance
  /// Largest t at which force + t change presses and lies within Coulomb's cone, for every change.
  double within_cone(const Eigen::Vector3d& force_O) const;
  /// Largest t at which force + t change stays below max_normal, for every change.
  double within_limit(const Eigen::Vector3d& force_O) const;
  /// An e at which both hold for all errors of length e [m], if every three columns of `changes`
  /// are those of one finger's error. Not the largest: the worst changes are taken to come
  /// together.
  double tolerates(const Eigen::Vector3d& force_O) const;
  static constexpr double kUnlimited = std::numeric_limits<double>::infinity();
};

/// Largest length to which a matrix maps a unit vector.
double largest_stretch(const Eigen::Matrix3d& of);

/// Throws std::invalid_argument unless there is one finite force a contact and one a finger.
void validate_nominal(const ContactSet& set, const Equilibrium& nominal);

/// Force at contact i; contacts come before fingers.
Eigen::Vector3d force_at(const Equilibrium& forces, std::size_t i);

/// Object on springs under disturbances, or with fingers beside their places.
struct Sprung {
  std::vector<Spring> springs;  ///< of the contacts, then of the fingers
  Matrix6Xd moved;              ///< twist of the object about its centre of mass, in O, for each
};

/// Springs with the changes of their forces when the object has moved until they balance
/// disturbances, `wrenches` about the centre of mass in O: R^-1/2 l_i. Nothing if the springs do
/// not hold the object. Arguments are not validated; a stiffness along the surface may be zero.
std::optional<Sprung> sprung(const ContactSet& set, const std::vector<FingerMode>& modes,
                             const Compliance& compliance, const Matrix6Xd& wrenches);

/// Springs with the changes of their forces per metre by which fingers are beside their places,
/// along the axes of O: three columns for each finger. Otherwise like sprung().
std::optional<Sprung> misplaced(const ContactSet& set, const std::vector<FingerMode>& modes,
                                const Compliance& compliance);

/// The same under disturbances along `directions` in scaled wrench space. Throws
/// std::invalid_argument on a bad contact set, modes, compliance or directions.
std::optional<Sprung> sprung_along(const ContactSet& set, const std::vector<FingerMode>& modes,
                                   const Compliance& compliance, const Matrix6Xd& directions);

// The public functions of these names, for springs that are known: those of sprung_along(). Only
// forces and yield are validated.
std::optional<Equilibrium> compliant_equilibrium(const ContactSet& set,
                                                 const std::vector<FingerMode>& modes,
                                                 const Eigen::VectorXd& commanded_forces,
                                                 const std::optional<Sprung>& found);
double compliant_stability(const ContactSet& set, const Equilibrium& nominal,
                           const std::optional<Sprung>& found);
Promise promise(const ContactSet& set, const std::vector<FingerMode>& modes,
                const Equilibrium& nominal, const Compliance& compliance, const Yield& yield,
                const Matrix6Xd& directions, const std::optional<Sprung>& found);

}  // namespace graspless::mechanics
