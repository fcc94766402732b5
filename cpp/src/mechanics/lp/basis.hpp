// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "mechanics/lp/program.hpp"

namespace graspless::mechanics {

/// Where the final basis of a simplex method leaves a row or a variable.
enum class BasisStatus : char { basic, at_lower, at_upper, free, fixed };

struct LpBasis {
  LpStatus status = LpStatus::infeasible;
  std::vector<BasisStatus> rows, variables;  ///< empty unless optimal
};

/// A solution with the digits that a double does not hold.
struct LpVertex {
  using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  LpSolution solution;
  Vector x, duals;  ///< empty unless optimal
};

/// x, duals and errors of a basis, to the accuracy of the problem rather than of the method that
/// found it. Errors are infinite when the basis is singular.
LpVertex vertex_of(const LinearProgram& lp, const LpBasis& basis);

/// What is left of a programme at a vertex that breaks some bound or sign: the origin moved to the
/// vertex and its errors magnified. A basis is optimal for both or for neither.
LinearProgram magnified(const LinearProgram& lp, const LpVertex& vertex);

}  // namespace graspless::mechanics
