// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/mechanics/stability.hpp"

namespace graspless::mechanics {

/// Bounds of an uncertain coefficient of friction, 0 <= lower <= upper. A single number stands for
/// both.
struct FrictionInterval {
  double lower = 0.5;
  double upper = lower;
};

/// Surfaces of the environment, such as the floor and a wall. All contacts with a surface share its
/// coefficient of friction; the coefficients of different surfaces vary independently.
struct Surfaces {
  std::vector<FrictionInterval> friction;  ///< of each surface
  std::vector<int> of_contact;             ///< index of each contact's surface
};

/// Largest number of surfaces whose coefficient is uncertain (lower < upper).
constexpr int kMaxUncertainSurfaces = 6;

/// Verdict on a contact set with fixed control modes and commanded forces: it holds if z >= needed
/// and nothing can jam, for all coefficients of friction in the intervals.
struct FrictionVerdict {
  bool holds = false;
  double least_stability = 0;  ///< proven lower bound on z over the intervals if it holds [N]
  /// If it does not hold: coefficients at which it fails (of each surface, and of the fingers), and
  /// the reason.
  std::vector<double> environment;
  double fingers = 0;
  std::string reason;
};

/// Proves that a contact set holds over intervals of friction, or finds coefficients at which it
/// fails. All fingers share one coefficient; the coefficients in `set` are ignored. Throws
/// std::invalid_argument on bad arguments.
///
/// The proof. z never falls when the cone of a finger or of a sticking contact grows, so these are
/// taken at their lower ends. Wider cones jam more easily (Problem (5)), so there they are taken at
/// their upper ends. The generator of a sliding contact is linear in its coefficient. Hence the
/// forces k_d that reach each target z l_d at one coefficient miss it by delta sum k_i t_i at
/// another, and by convexity z falls by at most the largest such miss, measured in the polyhedron
/// of the l_i. The misses of several surfaces add up. The intervals are halved until this settles
/// every piece, or coefficients fail.
GRASPLESS_API FrictionVerdict
holds_over_friction(const ContactSet& set, const std::vector<FingerMode>& modes,
                    const Eigen::VectorXd& commanded_forces, const Surfaces& environment,
                    const FrictionInterval& fingers, double needed,
                    const Matrix6Xd& directions = disturbance_directions());

/// The same for contacts that all share one coefficient.
GRASPLESS_API FrictionVerdict
holds_over_friction(const ContactSet& set, const std::vector<FingerMode>& modes,
                    const Eigen::VectorXd& commanded_forces, const FrictionInterval& environment,
                    const FrictionInterval& fingers, double needed,
                    const Matrix6Xd& directions = disturbance_directions());

}  // namespace graspless::mechanics
