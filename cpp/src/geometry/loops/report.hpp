// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "graspless/geometry/complex.hpp"
#include "graspless/geometry/loops.hpp"

/// Texts for users of shortest_loops: status, reason and warnings.
namespace graspless::geometry {

/// Three significant digits.
std::string short_number(double value);

/// Of a cloud: millimetres for metres, equal points.
std::vector<std::string> cloud_warnings(const Filtration& filtration);

/// No plateau is as wide as the options ask for.
std::string no_plateau_reason(const Filtration& filtration, const LoopOptions& options);

/// Fills in status, reason and warnings from the loops found.
void report(const Filtration& filtration, Loops& result);

}  // namespace graspless::geometry
