// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "graspless/clasp/problem.hpp"

namespace graspless::clasp {

/// Says how many hand poses around sampled points of the allowed loops the arm can reach, and how
/// far the others are beyond its reach. Obstacles and the object are ignored. Empty if the arm is
/// not a chain that ends at the palm.
GRASPLESS_API std::string describe_reach(const Problem& problem);

}  // namespace graspless::clasp
