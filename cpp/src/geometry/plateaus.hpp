// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/complex.hpp"

namespace graspless::geometry {

/// The stretches of a curve with at least one loop, widest ratio first.
std::vector<Plateau> plateaus(const BettiCurve& curve);

}  // namespace graspless::geometry
