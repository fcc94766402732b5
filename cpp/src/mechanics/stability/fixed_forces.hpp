// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/mechanics/stability.hpp"

#include "mechanics/lp/program.hpp"

namespace graspless::mechanics {

/// Problem (6) for given commanded forces. It decomposes into one linear program for each
/// direction.
class FixedForces {
 public:
  FixedForces(const ContactSet& set, const std::vector<FingerMode>& modes,
              const Eigen::VectorXd& commanded_forces);

  /// Largest z such that z l_i can be balanced, at most `enough`; 0 if there is no equilibrium.
  double reach(const Vector6d& direction, double enough = kInfinity) const;

  /// Least reach() over all directions.
  double stability(const Matrix6Xd& directions) const;

  /// Normal forces of the sliding contacts, in their order, that balance `target` with the least
  /// sum. `target` must lie within reach.
  Eigen::VectorXd sliding_forces(const Vector6d& target) const;

 private:
  Matrix6d even_;               // factor on both sides of the balance
  LinearProgram program_;       // coefficients k, rows of balance (right side: -known) and normals
  Vector6d known_;              // R^1/2 Q_known
  std::vector<int> sliding_;    // columns of sliding contacts
  std::vector<double> normal_;  // normal force per unit of each of them
};

/// Least sum of weights w >= 0 with sum w_i l_i = wrench. It is the factor by which the polyhedron
/// of the directions must be scaled to contain the wrench.
double gauge(const Matrix6Xd& directions, const Vector6d& wrench);

/// Largest gauge of the wrenches. Bounds save most of the linear programs.
double largest_gauge(const Matrix6Xd& directions, const std::vector<Vector6d>& wrenches);

}  // namespace graspless::mechanics
