// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "graspless/geometry/complex.hpp"
#include "graspless/geometry/loops.hpp"

/// Texts for users of shortest_loops: status, reason and warnings.
namespace graspless::geometry {

/// Warnings about a cloud: coordinates that look like millimetres, equal points.
std::vector<std::string> cloud_warnings(const Filtration& filtration);

/// Says that only some of the points are used, as all lie at random.
std::string thinning_warning(std::size_t used);

/// Sets status, reason and warnings from the loops found.
void report(const Filtration& filtration, const LoopOptions& options, Loops& result);

}  // namespace graspless::geometry
