// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mechanics/lp/basis.hpp"

namespace graspless::mechanics {

/// Variant of the simplex method.
struct GlpkMethod {
  bool dual = true;         ///< dual or primal simplex; never with presolve
  double tolerance = 1e-9;  ///< tolerance of bounds and of reduced costs
  bool scaled = false;      ///< rows and columns are brought to one size first
};

/// Runs GLPK's simplex method, from `basis` unless that is empty, and sets `basis` to the final
/// one. Returns false if there is none. GLPK keeps memory per thread, which is freed when the
/// thread ends. Its fatal errors would end the process; they are caught.
bool find_basis(const LinearProgram& lp, const GlpkMethod& method, LpBasis* basis);

}  // namespace graspless::mechanics
