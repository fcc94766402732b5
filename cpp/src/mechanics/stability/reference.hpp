// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {

/// Problems (5) and (6) as the paper writes them, solved by GLPK: slow and plain. The fast engine is
/// tested against it, and hands over the contact sets that are too ill-conditioned for itself.
/// Contacts that resist some wrench 1e13 times less than another count as not resisting it.
/// Methods throw std::runtime_error when no answer of GLPK passes the checks of solve_lp().
class Reference {
 public:
  /// A validated contact set. Its wrenches are worked out without rounding where that matters.
  explicit Reference(const ContactSet& set);
  /// Wrenches that are rounded already. Several environments share the commanded forces.
  Reference(const std::vector<const EnvironmentWrenches*>& environments,
            const std::vector<const FingerWrenches*>& fingers);

  /// Problem (6) in one piece.
  Stability max_stability(ForceMask force, const Matrix6Xd& directions) const;
  /// max_stability() without the binding directions.
  Stability evaluate(ForceMask force, const Matrix6Xd& directions) const;
  /// Problem (5).
  bool internal_force_is_bounded(ForceMask force) const;

 private:
  /// The balance of one environment and the fingers, in rows of even size.
  struct Balance {
    Eigen::MatrixXd rows;  ///< what the rows of the paper are multiplied with
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
