// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which d: where the same loops live on for long.
#include "geometry/plateaus.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::geometry {
namespace {

/// Above the lower end of a plateau, relative to it.
constexpr double kAbove = 1.05;

using Pairs = std::vector<PersistencePair>;

Pairs lasting_pairs(const Pairs& pairs, double lasting) {
  Pairs result;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(result),
               [&](const PersistencePair& pair) { return pair.death >= lasting * pair.birth; });
  return result;
}

/// How many of the pairs live on both plateaus and between them.
int shared_loops(const Pairs& pairs, const Plateau& lower, const Plateau& upper) {
  return static_cast<int>(
      std::count_if(pairs.begin(), pairs.end(), [&](const PersistencePair& pair) {
        return pair.birth <= lower.lower && pair.death >= upper.upper;
      }));
}

/// The lowest plateau on which exactly the loops of this one live: they are finer there.
Plateau lowest_of_the_same(const std::vector<Plateau>& all, const Plateau& chosen,
                           const Pairs& pairs, double min_ratio) {
  Plateau result = chosen;
  for (const Plateau& plateau : all) {
    if (plateau.lower < result.lower && plateau.loops == chosen.loops &&
        plateau.ratio() >= min_ratio && shared_loops(pairs, plateau, chosen) == chosen.loops) {
      result = plateau;
    }
  }
  return result;
}

}  // namespace

std::vector<Plateau> plateaus(const Pairs& pairs, double lasting) {
  std::vector<std::pair<double, int>> steps;
  for (const PersistencePair& pair : lasting_pairs(pairs, lasting)) {
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

std::optional<Plateau> choose_plateau(const Filtration& filtration, const LoopOptions& options) {
  const std::vector<Plateau> all = filtration.plateaus();
  if (options.lowest_plateau) {
    std::optional<Plateau> lowest;
    for (const Plateau& plateau : all) {
      if (plateau.ratio() < std::max(options.lowest_ratio, options.min_ratio)) break;
      if (!lowest || plateau.lower < lowest->lower) lowest = plateau;
    }
    return lowest;
  }
  if (all.empty() || all[0].ratio() < options.min_ratio) return std::nullopt;
  return lowest_of_the_same(all, all[0], lasting_pairs(filtration.persistence(), kLasting),
                            options.min_ratio);
}

double edge_length_on(const Plateau& plateau, const BettiCurve& curve) {
  double widest = 1, d = std::min(kAbove, std::sqrt(plateau.ratio())) * plateau.lower;
  for (std::size_t i = 0; i + 1 < curve.loops.size(); ++i) {
    const double lower = std::max(curve.max_edge_length[i], plateau.lower);
    const double upper = std::min(curve.max_edge_length[i + 1], plateau.upper);
    if (curve.loops[i] != plateau.loops || upper <= widest * lower) continue;
    widest = upper / lower;
    d = std::min(kAbove, std::sqrt(widest)) * lower;
    if (widest >= kAbove) break;  // the first that leaves room
  }
  return d;
}

}  // namespace graspless::geometry
