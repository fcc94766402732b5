// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "fingertip/check/instant.hpp"
#include "mechanics/lp/basis.hpp"

namespace graspless::fingertip::checking {

/// Solves Problem (6) with f_com fixed. Mostly the same contacts carry the largest z of a direction
/// at the next instant. A direction in which they carry more than the least z so far is not solved,
/// nor is one in which their forces can be mixed with inner ones, which carry nothing, to carry z.
class Stabilities {
 public:
  explicit Stabilities(mechanics::Matrix6Xd directions)
      : directions_(std::move(directions)),
        supports_(directions_.cols()),
        bases_(supports_.size()) {}

  /// The least over the directions l_d of the largest z with z l_d in balance; 0 without an
  /// equilibrium.
  double least(const Instant& instant);

 private:
  /// Columns of balance() that are not 0 at an optimum, and rows that are at a bound.
  struct Support {
    std::vector<int> columns, rows;
  };

  static Support support_of(const Eigen::VectorXd& x, const mechanics::LinearProgram& lp,
                            const Eigen::MatrixXd& A);
  static bool holds(const Support& support, const mechanics::LinearProgram& lp,
                    const Eigen::MatrixXd& A, const Eigen::VectorXd& inner, double z);
  Eigen::VectorXd inner(mechanics::LinearProgram lp, const Eigen::MatrixXd& A);

  mechanics::Matrix6Xd directions_;
  // Of each direction, at the last instant at which it was solved.
  std::vector<Support> supports_;
  std::vector<mechanics::LpBasis> bases_;
  mechanics::LpBasis inner_basis_;  // of the last instant
  Eigen::Index weakest_ = 0;        // direction of the last instant
};

}  // namespace graspless::fingertip::checking
