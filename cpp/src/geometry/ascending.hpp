// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace graspless::geometry {

/// Indices of numbers in ascending order, equal ones as they come. None may be NaN. Sorts by one
/// digit after the other, which is faster than comparisons for more than a few hundred.
std::vector<int> ascending(const std::vector<double>& numbers);

}  // namespace graspless::geometry
