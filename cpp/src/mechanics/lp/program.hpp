// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace graspless::mechanics {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Linear program: maximise objective . x  subject to  row_lower <= A x <= row_upper,
/// lower <= x <= upper. Bounds may be infinite.
class LinearProgram {
 public:
  /// Adds a variable with its bounds and its coefficient in the objective. Returns its index.
  int add_variable(double lower, double upper, double objective = 0);
  /// Adds a row without entries. Returns its index.
  int add_row(double lower, double upper);
  /// Sets A(row, column) = value, once per entry. Values below 1e-12 are rounding errors of
  /// products that vanish, and are left out: an entry of 1e-17 is enough to mislead a simplex
  /// method.
  void set(int row, int column, double value);
  /// Calls set() for every entry of a block whose first entry is A(row, column).
  void set_block(int row, int column, const Eigen::Ref<const Eigen::MatrixXd>& block);

  Eigen::Index num_rows() const { return static_cast<Eigen::Index>(row_lower.size()); }
  Eigen::Index num_variables() const { return static_cast<Eigen::Index>(lower.size()); }

  std::vector<double> objective, lower, upper, row_lower, row_upper;
  std::vector<Eigen::Triplet<double>> entries;
};

enum class LpStatus { optimal, infeasible, unbounded };

struct LpSolution {
  LpStatus status = LpStatus::infeasible;
  double objective = 0;     ///< value at the optimum; infinite if unbounded
  Eigen::VectorXd x;        ///< empty unless optimal
  Eigen::VectorXd duals;    ///< increase of the objective per unit of a row's bound
  double primal_error = 0;  ///< largest violation of a row or a bound
  double dual_error = 0;    ///< largest reduced cost of the wrong sign
};

/// Solves by GLPK's dual simplex method, computes x and the duals again from the final basis (LU
/// with iterative refinement), and improves the basis until errors are below 1e-13 where that is
/// possible. May be called from any thread. Throws std::invalid_argument on entries or bounds that
/// are not finite where they must be, crossed, out of range or given twice, and std::runtime_error
/// if GLPK gives up or errors stay above 1e-6. GLPK alone decides, to its tolerance of 1e-9, that a
/// program is unbounded. What it calls infeasible is, unless a vertex proves the opposite.
LpSolution solve_lp(const LinearProgram& lp);

}  // namespace graspless::mechanics
