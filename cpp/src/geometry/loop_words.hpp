// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "graspless/geometry/complex.hpp"
#include "graspless/geometry/loops.hpp"

/// What shortest_loops says to people.
namespace graspless::geometry {

/// Of a cloud: millimetres for metres, equal points.
std::vector<std::string> cloud_warnings(const Filtration& filtration);

/// No plateau is as wide as the options ask for.
std::string why_no_plateau(const Filtration& filtration, const LoopOptions& options);

/// Fills in status, reason and warnings from the loops found.
void conclude(const Filtration& filtration, Loops& result);

}  // namespace graspless::geometry
