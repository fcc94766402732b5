// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mechanics/lp/basis.hpp"

namespace graspless::mechanics {

struct GlpkMethod {
  bool dual = true;         ///< dual or primal simplex; never with presolve
  double tolerance = 1e-9;  ///< of bounds and of reduced costs
};

/// The final basis of GLPK's simplex method, which starts from `basis` unless that is empty; false
/// when it gives none. GLPK keeps its memory per
/// thread: it is freed when the thread ends. Its fatal errors, which end the process, are caught.
bool find_basis(const LinearProgram& lp, const GlpkMethod& method, LpBasis* basis);

}  // namespace graspless::mechanics
