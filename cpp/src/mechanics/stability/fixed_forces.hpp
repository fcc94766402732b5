// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/mechanics/stability.hpp"

#include "mechanics/lp/program.hpp"

namespace graspless::mechanics {

/// Problem (6) where the commanded forces are given: it falls apart into one programme a direction.
class FixedForces {
 public:
  FixedForces(const ContactSet& set, const std::vector<FingerMode>& modes,
              const Eigen::VectorXd& commanded_forces);

  /// The largest z such that z l_i can be balanced, up to `enough`; 0 when there is no equilibrium.
  double reach(const Vector6d& direction, double enough = kInfinity) const;

  /// The least of these.
  double stability(const Matrix6Xd& directions) const;

  /// Normal forces of the sliding contacts, one each in their order, that balance `target` with the
  /// least sum. `target` must lie within reach.
  Eigen::VectorXd sliding_forces(const Vector6d& target) const;

 private:
  Matrix6d even_;               // on both sides of the balance
  LinearProgram program_;       // coefficients k, rows of balance (right side: -known) and normals
  Vector6d known_;              // R^1/2 Q_known
  std::vector<int> sliding_;    // columns of sliding contacts
  std::vector<double> normal_;  // normal force per unit of those
};

/// The least sum of weights w >= 0 with sum w_i l_i = wrench: how large the polyhedron of the
/// directions must be to hold the wrench.
double gauge(const Matrix6Xd& directions, const Vector6d& wrench);

/// The largest gauge of some wrenches; solves for few of them.
double largest_gauge(const Matrix6Xd& directions, const std::vector<Vector6d>& wrenches);

}  // namespace graspless::mechanics
