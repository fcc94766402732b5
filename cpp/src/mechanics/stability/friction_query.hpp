// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/mechanics/friction_interval.hpp"

namespace graspless::mechanics {

using Intervals = std::vector<FrictionInterval>;  // of each surface
using Coefficients = std::vector<double>;         // of each surface

/// Arguments of holds_over_friction().
struct FrictionQuery {
  const ContactSet& set;
  const std::vector<FingerMode>& modes;
  const Eigen::VectorXd& commanded_forces;
  const Surfaces& environment;
  FrictionInterval fingers;
  double needed;
  const Matrix6Xd& directions;

  /// Surface of a contact.
  std::size_t surface(std::size_t contact) const {
    return static_cast<std::size_t>(environment.of_contact[contact]);
  }
};

inline double width(const FrictionInterval& interval) { return interval.upper - interval.lower; }

/// Lower ends, upper ends and middles of all intervals.
Coefficients lower_ends(const Intervals& intervals);
Coefficients upper_ends(const Intervals& intervals);
Coefficients middles(const Intervals& intervals);

/// Throws std::invalid_argument on bad arguments.
void validate(const FrictionQuery& query);

/// The contact set with other coefficients of friction.
ContactSet with_friction(const FrictionQuery& query, const Coefficients& stick,
                         const Coefficients& slide, double fingers);

/// Surfaces with an uncertain coefficient that a contact of this mode touches.
std::vector<std::size_t> uncertain_surfaces(const FrictionQuery& query, ContactMode mode);

/// All lower ends, all upper ends, and then every mixture of the ends of `varied` surfaces, where
/// the other surfaces have the coefficients `others`.
std::vector<Coefficients> ends(const Intervals& intervals, const std::vector<std::size_t>& varied,
                               const Coefficients& others);

}  // namespace graspless::mechanics
