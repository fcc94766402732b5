// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/fingertip/fingertip.hpp"

namespace graspless::fingertip {

/// Says of a plan that was not found which limit blocks (`limit`, and where in `reason`) and the
/// smallest single changes that make it solvable (`relaxations`), by planning anew with other
/// values in what the clock has left. Changes with which one regrasp is enough come first, since
/// more of them take long to exclude: when the clock ends meanwhile, the changes found help but may
/// not be the smallest. The same failure and time enough give the same answer.
void explain(const Problem& problem, const Options& options, planning::Clock& clock, Plan& plan);

}  // namespace graspless::fingertip
