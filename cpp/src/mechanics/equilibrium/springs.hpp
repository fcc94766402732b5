// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "graspless/mechanics/equilibrium.hpp"

namespace graspless::mechanics {

/// One contact as a spring about its nominal force.
struct Spring {
  Eigen::Vector3d n;               ///< normal into the object, in O
  double friction = 0;             ///< coefficient
  double max_normal = kUnlimited;  ///< [N]
  bool follows = false;  ///< slides: its friction follows the normal force and cannot slip further
  Eigen::Matrix3Xd changes;  ///< of the force on the object per unit of each disturbance
  /// The largest t at which force + t change presses and lies within Coulomb's cone for every
  /// change.
  double within_cone(const Eigen::Vector3d& force_O) const;
  /// The same of force + t change below max_normal.
  double within_limit(const Eigen::Vector3d& force_O) const;
  static constexpr double kUnlimited = std::numeric_limits<double>::infinity();
};

/// The force at contact i, contacts before fingers.
Eigen::Vector3d force_at(const Equilibrium& forces, std::size_t i);

/// Contacts, then fingers, and how disturbances change their forces while the object moves until
/// the springs balance them. Nothing where the springs do not hold the object. Throws
/// std::invalid_argument on a bad contact set, modes, compliance or directions.
std::optional<std::vector<Spring>> springs_under(const ContactSet& set,
                                                 const std::vector<FingerMode>& modes,
                                                 const Compliance& compliance,
                                                 const Matrix6Xd& directions);

}  // namespace graspless::mechanics
