// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace graspless::mechanics {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// maximise objective . x  subject to  row_lower <= A x <= row_upper,  lower <= x <= upper.
/// Bounds may be infinite.
class LinearProgram {
 public:
  /// A variable of its own bounds and coefficient in the objective; gives its index.
  int add_variable(double lower, double upper, double objective = 0);
  /// A row without entries; gives its index.
  int add_row(double lower, double upper);
  /// A(row, column) = value. Entries below 1e-12 are rounding of products that vanish, and are left
  /// out: one of 1e-17 is enough to lead a simplex method astray. An entry may be given once.
  void set(int row, int column, double value);
  /// set() for all of a block whose first entry is A(row, column).
  void set_block(int row, int column, const Eigen::Ref<const Eigen::MatrixXd>& block);

  Eigen::Index num_rows() const { return static_cast<Eigen::Index>(row_lower.size()); }
  Eigen::Index num_variables() const { return static_cast<Eigen::Index>(lower.size()); }

  std::vector<double> objective, lower, upper, row_lower, row_upper;
  std::vector<Eigen::Triplet<double>> entries;
};

enum class LpStatus { optimal, infeasible, unbounded };

struct LpSolution {
  LpStatus status = LpStatus::infeasible;
  double objective = 0;     ///< of the optimum; infinite when unbounded
  Eigen::VectorXd x;        ///< empty unless optimal
  Eigen::VectorXd duals;    ///< what the objective gains per unit of a row's bound
  double primal_error = 0;  ///< the most by which x breaks a row or a bound
  double dual_error = 0;    ///< the most by which a reduced cost has the wrong sign
};

/// Solves by GLPK's dual simplex method, then works out x and the duals anew from the final basis
/// (LU with iterative refinement). May be called from any thread. Throws std::invalid_argument on
/// entries or bounds that are not finite where they must be, crossed, out of range or given twice,
/// and std::runtime_error when GLPK gives up or the errors stay above 1e-6. That a programme is
/// infeasible or unbounded is GLPK's word, to its tolerance of 1e-9.
LpSolution solve_lp(const LinearProgram& lp);

}  // namespace graspless::mechanics
