// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plateaus of the Betti curve, and the choice of d on one.
#include "geometry/complex/plateaus.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::geometry {
namespace {

/// Ratio of d to the lower end of the interval it is chosen in.
constexpr double kAbove = 1.05;

using Pairs = std::vector<PersistencePair>;

Pairs lasting_pairs(const Pairs& pairs, double lasting_ratio) {
  Pairs result;
  std::copy_if(
      pairs.begin(), pairs.end(), std::back_inserter(result),
      [&](const PersistencePair& pair) { return pair.death >= lasting_ratio * pair.birth; });
  return result;
}

}  // namespace

std::vector<Plateau> plateaus(const Pairs& pairs, double lasting_ratio) {
  std::vector<std::pair<double, int>> steps;
  for (const PersistencePair& pair : lasting_pairs(pairs, lasting_ratio)) {
    steps.emplace_back(pair.birth, 1);
    steps.emplace_back(pair.death, -1);
  }
  std::sort(steps.begin(), steps.end());
  std::vector<Plateau> result;
  int loops = 0;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    loops += steps[i].second;
    const double lower = steps[i].first, upper = steps[i + 1].first;
    if (loops > 0 && lower < upper) result.push_back({lower, upper, loops});
  }
  std::stable_sort(result.begin(), result.end(), [](const Plateau& a, const Plateau& b) {
    return a.upper * b.lower > b.upper * a.lower;
  });
  return result;
}

double edge_length_on(const Plateau& plateau, const BettiCurve& curve) {
  double widest = 1, d = std::min(kAbove, std::sqrt(plateau.ratio())) * plateau.lower;
  for (std::size_t i = 0; i + 1 < curve.loops.size(); ++i) {
    const double lower = std::max(curve.max_edge_length[i], plateau.lower);
    const double upper = std::min(curve.max_edge_length[i + 1], plateau.upper);
    if (curve.loops[i] != plateau.loops || upper <= widest * lower) continue;
    widest = upper / lower;
    d = std::min(kAbove, std::sqrt(widest)) * lower;
    if (widest >= kAbove) break;  // lowest interval that is wide enough
  }
  return d;
}

}  // namespace graspless::geometry
