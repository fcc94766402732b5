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

constexpr int kMaxRows = 6 + static_cast<int>(mechanics::kMaxFingers);  // of balance()
using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxRows, kMaxRows>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxRows, 1>;

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
    if (at[i] >= lp.row_upper[i] - least) support.rows.push_back(i);
  }
  return support;
}

/// True if the forces of a support, mixed with the inner ones, are in balance with z l_d or more.
bool Stabilities::holds(const Support& support, const LinearProgram& lp, const MatrixXd& A,
                        const VectorXd& inner, double z) {
  const auto size = static_cast<Eigen::Index>(support.columns.size());
  if (size == 0 || support.columns.front() != 0 || support.columns.back() >= A.cols()) return false;
  if (support.rows.size() != support.columns.size() || support.rows.back() >= A.rows())
    return false;
  const auto lower = Eigen::Map<const VectorXd>(lp.row_lower.data(), lp.num_rows());
  const auto upper = Eigen::Map<const VectorXd>(lp.row_upper.data(), lp.num_rows());
  if (support.rows.size() > kMaxRows) return false;
  const Small carried = A(support.rows, support.columns);
  const SmallVector most = upper(support.rows), carrying = carried.partialPivLu().solve(most);
  if (!carrying.allFinite() || carrying[0] < z * (1 - kSame)) return false;
  VectorXd x = VectorXd::Zero(A.cols());
  x(support.columns) = carrying;
  if (inner.size() > 0 && z < x[0]) x = inner + z / x[0] * (x - inner);
  const double error = kRounding * std::max(1.0, x.lpNorm<Eigen::Infinity>());
  const Eigen::ArrayXd at = A * x;
  return x.minCoeff() >= -error && (at <= upper.array() + error).all() &&
         (at >= lower.array() - error).all();
}

/// Forces in balance without a disturbance, the least as large as possible, up to the weight; empty
/// if there are none. Coefficients are t + k, k >= 0: column 0, t, has the sum of all columns.
VectorXd Stabilities::inner(LinearProgram lp, const MatrixXd& A) {
  lp.upper[0] = Eigen::Map<const VectorXd>(lp.row_upper.data(), 6).norm();
  lp.set_block(0, 0, A.rowwise().sum());
  const mechanics::LpSolution found = mechanics::solve_lp(lp, inner_basis_);
  if (found.status != mechanics::LpStatus::optimal) return {};
  VectorXd x = found.x.array() + found.x[0];
  x[0] = 0;
  return x;
}

double Stabilities::least(const Instant& instant) {
  const LinearProgram lp = balance(instant);
  MatrixXd A = matrix_of(lp);
  const VectorXd undisturbed = inner(lp, A);
  double z = kInfinity;
  const Eigen::Index first = weakest_;
  for (Eigen::Index i = 0; i < directions_.cols() && z > 0; ++i) {
    const Eigen::Index d = (first + i) % directions_.cols();
    const auto at = static_cast<std::size_t>(d);
    Support& support = supports_[at];
    A.col(0).head<6>() = directions_.col(d);
    if (std::isfinite(z) && holds(support, lp, A, undisturbed, z)) continue;
    LinearProgram program = lp;
    program.set_block(0, 0, directions_.col(d));
    const mechanics::LpSolution found = mechanics::solve_lp(program, bases_[at]);
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
