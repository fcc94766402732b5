// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/complex.hpp"

namespace graspless::geometry {

/// Intervals of d in which at least one lasting pair is alive and none is born or dies; largest
/// ratio first. A pair is lasting if death / birth is at least `lasting_ratio`.
std::vector<Plateau> plateaus(const std::vector<PersistencePair>& pairs, double lasting_ratio);

/// Chooses d near the lower end of a plateau, where K_d is fine and its loops are short. If
/// possible, only the plateau's own loops are alive at d.
double edge_length_on(const Plateau& plateau, const BettiCurve& curve);

}  // namespace graspless::geometry
