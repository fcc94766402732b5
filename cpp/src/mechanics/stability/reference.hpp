// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {

/// Problems (5) and (6) as the paper writes them, solved by GLPK: slow and simple. The fast engine
/// is tested against it, and hands over contact sets that are too ill-conditioned for rays.
/// Contacts that resist some wrench 1e13 times less than another one count as not resisting it. The
/// methods throw std::runtime_error if no answer of GLPK passes the checks of solve_lp().
class Reference {
 public:
  /// Takes a validated contact set. If it is ill-conditioned, its wrenches are computed exactly.
  explicit Reference(const ContactSet& set);
  /// Takes rounded wrenches. Several environments share the commanded forces.
  Reference(const std::vector<const EnvironmentWrenches*>& environments,
            const std::vector<const FingerWrenches*>& fingers);

  /// Problem (6) in one piece.
  Stability max_stability(ForceMask force, const Matrix6Xd& directions) const;
  /// max_stability() without the binding directions.
  Stability evaluate(ForceMask force, const Matrix6Xd& directions) const;
  /// Problem (5): returns true if nothing can jam.
  bool internal_force_is_bounded(ForceMask force) const;

 private:
  /// Balance of one environment and the fingers, with rows of equal strength.
  struct Balance {
    Eigen::MatrixXd rows;  ///< factor of the paper's balance
    Eigen::MatrixXd environment;
    std::vector<Eigen::MatrixXd> fingers;
    Eigen::VectorXd known;
  };
  struct Program;
  std::vector<Balance> balances() const;
  double force_scale() const;
  Stability evaluate(const std::vector<Balance>& balances, ForceMask force,
                     const Matrix6Xd& directions) const;
  Program program(const std::vector<Balance>& balances, ForceMask force,
                  const Matrix6Xd& directions) const;
  std::vector<int> binding(const std::vector<Balance>& balances, ForceMask force,
                           const Matrix6Xd& directions, const Stability& stability) const;

  std::optional<ContactSet> set_;
  std::vector<EnvironmentWrenches> environments_;
  std::vector<FingerWrenches> fingers_;
};

}  // namespace graspless::mechanics
