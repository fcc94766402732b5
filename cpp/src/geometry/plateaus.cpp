// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/plateaus.hpp"

#include <algorithm>

namespace graspless::geometry {

std::vector<Plateau> plateaus(const BettiCurve& curve) {
  std::vector<Plateau> result;
  for (std::size_t i = 0; i + 1 < curve.loops.size(); ++i) {  // the last step leaves no loop
    if (curve.loops[i] == 0) continue;
    result.push_back({curve.max_edge_length[i], curve.max_edge_length[i + 1], curve.loops[i]});
  }
  std::stable_sort(result.begin(), result.end(), [](const Plateau& a, const Plateau& b) {
    return a.upper * b.lower > b.upper * a.lower;
  });
  return result;
}

}  // namespace graspless::geometry
