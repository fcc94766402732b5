// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/mechanics/stability.hpp"

namespace graspless::mechanics {

/// Bounds of an uncertain coefficient of friction, 0 <= lower <= upper.
struct FrictionInterval {
  double lower = 0.5;
  double upper = 0.5;
};

/// Verdict on a contact set with fixed control modes and commanded forces: it holds if z >= needed
/// and nothing can jam, for all coefficients of friction in the intervals.
struct FrictionVerdict {
  bool holds = false;
  double least_stability = 0;  ///< proven lower bound on z over the intervals if it holds [N]
  /// If it does not hold: coefficients at which it fails, and the reason.
  double environment = 0, fingers = 0;
  std::string reason;
};

/// Proves that a contact set holds over intervals of friction, or finds coefficients at which it
/// fails. All contacts share one coefficient, and so do all fingers; the coefficients in `set` are
/// ignored. Throws std::invalid_argument on bad arguments.
///
/// The proof. z never falls when the cone of a finger or of a sticking contact grows, so these are
/// taken at their lower ends. Wider cones jam more easily (Problem (5)), so there they are taken at
/// their upper ends. The generator of a sliding contact is linear in its coefficient. Hence the
/// forces k_d that reach each target z l_d at one coefficient miss it by delta sum k_i t_i at
/// another, and by convexity z falls by at most the largest such miss, measured in the polyhedron
/// of the l_i. The interval is halved until this settles every piece, or a coefficient fails.
GRASPLESS_API FrictionVerdict
holds_over_friction(const ContactSet& set, const std::vector<FingerMode>& modes,
                    const Eigen::VectorXd& commanded_forces, const FrictionInterval& environment,
                    const FrictionInterval& fingers, double needed,
                    const Matrix6Xd& directions = disturbance_directions());

}  // namespace graspless::mechanics
