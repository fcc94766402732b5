// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/complex.hpp"

namespace graspless::geometry {

/// The stretches of d on which at least one of the pairs that last is alive, and no such pair
/// begins or ends; widest ratio first.
std::vector<Plateau> plateaus(const std::vector<PersistencePair>& pairs, double lasting);

/// A d near the lower end of a plateau (loops are shortest on a fine complex), where no other loops
/// are alive if there is such a place.
double edge_length_on(const Plateau& plateau, const BettiCurve& curve);

}  // namespace graspless::geometry
