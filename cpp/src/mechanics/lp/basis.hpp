// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "mechanics/lp/program.hpp"

namespace graspless::mechanics {

/// Status of a row or a variable in the final basis of a simplex method.
enum class BasisStatus : char { basic, at_lower, at_upper, free, fixed };

struct LpBasis {
  LpStatus status = LpStatus::infeasible;
  std::vector<BasisStatus> rows, variables;  ///< empty unless optimal
};

/// Solution in extended precision.
struct LpVertex {
  using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  LpBasis basis;
  LpSolution solution;
  Vector x, duals;  ///< empty unless optimal
};

/// Computes x, duals and errors of a basis, to the accuracy of the problem rather than of the
/// method that found it. Errors are infinite if the basis is singular.
LpVertex vertex_of(const LinearProgram& lp, const LpBasis& basis);

/// Same as solve_lp(lp), but begins at `basis`, and sets it to the final one. Fast if that of a
/// similar program is given. Any basis may be given, also one that does not fit.
LpSolution solve_lp(const LinearProgram& lp, LpBasis& basis);

/// Returns the program with its origin moved to a vertex, and with the vertex's errors magnified. A
/// basis is optimal for both programs or for neither.
LinearProgram magnified(const LinearProgram& lp, const LpVertex& vertex);

}  // namespace graspless::mechanics
