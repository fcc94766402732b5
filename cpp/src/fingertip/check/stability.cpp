// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/check/stability.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace graspless::fingertip::checking {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using mechanics::kInfinity;
using mechanics::LinearProgram;

constexpr double kRounding = 1e-10;  // of forces, relative to the largest
constexpr double kSame = 1e-12;      // relative difference of two z that are the same

MatrixXd matrix_of(const LinearProgram& lp) {
  MatrixXd A = MatrixXd::Zero(lp.num_rows(), lp.num_variables());
  for (const auto& entry : lp.entries) A(entry.row(), entry.col()) = entry.value();
  return A;
}

}  // namespace

/// The forces that carry an optimum.
Stabilities::Support Stabilities::support_of(const VectorXd& x, const LinearProgram& lp,
                                             const MatrixXd& A) {
  Support support;
  if (x.size() == 0) return support;  // unbounded
  const double least = kRounding * std::max(1.0, x.lpNorm<Eigen::Infinity>());
  for (int j = 0; j < x.size(); ++j) {
    if (x[j] > least) support.columns.push_back(j);
  }
  const VectorXd at = A * x;
  for (int i = 0; i < at.size(); ++i) {
    if (at[i] >= lp.row_upper[static_cast<std::size_t>(i)] - least) support.rows.push_back(i);
  }
  return support;
}

/// True if the forces of a support are in balance with z l_d or more.
bool Stabilities::holds(const Support& support, const LinearProgram& lp, const MatrixXd& A,
                        double z) {
  const auto size = static_cast<Eigen::Index>(support.columns.size());
  if (size == 0 || support.columns.front() != 0 || support.columns.back() >= A.cols()) return false;
  if (support.rows.size() != support.columns.size() || support.rows.back() >= A.rows())
    return false;
  const auto lower = Eigen::Map<const VectorXd>(lp.row_lower.data(), lp.num_rows());
  const auto upper = Eigen::Map<const VectorXd>(lp.row_upper.data(), lp.num_rows());
  const MatrixXd carried = A(Eigen::all, support.columns);
  const VectorXd x = carried(support.rows, Eigen::all).partialPivLu().solve(upper(support.rows));
  if (!x.allFinite() || x[0] < z * (1 - kSame)) return false;
  const double error = kRounding * std::max(1.0, x.lpNorm<Eigen::Infinity>());
  const Eigen::ArrayXd at = carried * x;
  return x.minCoeff() >= -error && (at <= upper.array() + error).all() &&
         (at >= lower.array() - error).all();
}

double Stabilities::least(const Instant& instant) {
  const LinearProgram lp = balance(instant);
  MatrixXd A = matrix_of(lp);
  double z = kInfinity;
  const Eigen::Index first = weakest_;
  for (Eigen::Index i = 0; i < directions_.cols() && z > 0; ++i) {
    const Eigen::Index d = (first + i) % directions_.cols();
    Support& support = supports_[static_cast<std::size_t>(d)];
    A.col(0).head<6>() = directions_.col(d);
    if (std::isfinite(z) && holds(support, lp, A, z)) continue;
    LinearProgram program = lp;
    program.set_block(0, 0, directions_.col(d));
    const mechanics::LpSolution found = mechanics::solve_lp(program);
    if (found.status == mechanics::LpStatus::infeasible) return 0;
    support = support_of(found.x, lp, A);
    if (found.objective < z) {
      z = found.objective;
      weakest_ = d;
    }
  }
  return z;
}

}  // namespace graspless::fingertip::checking
