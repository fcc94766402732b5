// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/cycles/shortest_basis.hpp"

namespace graspless::geometry {

/// Largest and smallest width of the cross-sections of a handle, at the thinnest ones [m]; 0 if
/// unknown.
struct Thickness {
  double widest = 0, narrowest = 0;
};

/// Thickness of the handles that cycles run along, for each cycle.
std::vector<Thickness> thickness(const Complex& complex, const std::vector<Cycle>& cycles);

}  // namespace graspless::geometry
