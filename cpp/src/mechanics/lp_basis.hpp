// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "mechanics/lp.hpp"

namespace graspless::mechanics {

/// Where the final basis of a simplex method leaves a row or a variable.
enum class BasisStatus : char { basic, at_lower, at_upper, free, fixed };

struct LpBasis {
  LpStatus status = LpStatus::infeasible;
  std::vector<BasisStatus> rows, variables;  ///< looked at when optimal
};

/// x, duals and errors of a basis, to the accuracy of the problem rather than of the method that
/// found it. Errors are infinite when the basis is singular.
LpSolution solution_of(const LinearProgram& lp, const LpBasis& basis);

}  // namespace graspless::mechanics
