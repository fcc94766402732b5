// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/mechanics/stability.hpp"

namespace graspless::mechanics {

/// A coefficient of friction that is known to lie within bounds.
struct FrictionInterval {
  double lower = 0.5;
  double upper = 0.5;
};

/// Whether a contact set with fixed control modes and commanded forces keeps z >= needed, and
/// cannot jam, for all coefficients in the intervals.
struct FrictionVerdict {
  bool holds = false;
  double least_stability = 0;  ///< a proven lower bound on z over the intervals when it holds [N]
  /// When it does not hold: coefficients (environment, fingers) at which it fails, and how.
  double environment = 0, fingers = 0;
  std::string reason;
};

/// Shown thus. z never falls when a finger's or a sticking contact's cone grows, so those are taken
/// at their lower ends; jamming (5) is possible the sooner the wider the cones, so those are taken
/// at their upper ends. The generator of a sliding contact is linear in its coefficient: the forces
/// k_d that reach each target z l_d at one coefficient miss it by delta sum k_i t_i at another, and
/// by convexity z falls by at most the largest such miss, measured in the polyhedron of the l_i.
/// The interval is halved until every piece is settled so, or a coefficient fails. All contacts
/// share one coefficient, and so do all fingers; those in `set` are not looked at.
GRASPLESS_API FrictionVerdict
holds_over_friction(const ContactSet& set, const std::vector<FingerMode>& modes,
                    const Eigen::VectorXd& commanded_forces, const FrictionInterval& environment,
                    const FrictionInterval& fingers, double needed,
                    const Matrix6Xd& directions = disturbance_directions());

}  // namespace graspless::mechanics
