// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/scales.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/complex/plateaus.hpp"

namespace graspless::geometry {
namespace {

/// Least ratio of a plateau that is clear of other classes, and largest d relative to the death of
/// its holes.
constexpr double kClearRatio = 1.2, kCoarsest = 0.75;

/// The values of d that most classes accept; the lowest of them, where K_d is finest.
Plateau common_scale(const Judged& classes) {
  std::vector<PersistencePair> scales;
  for (const JudgedClass& judged : classes)
    scales.push_back({judged.span.birth, judged.coarsest()});
  Plateau best;
  for (const Plateau& plateau : plateaus(scales, 1)) {
    if (plateau.loops > best.loops || (plateau.loops == best.loops && plateau.lower < best.lower))
      best = plateau;
  }
  return best;
}

}  // namespace

Judged holes_of(const Judged& classes) {
  Judged holes;
  std::copy_if(classes.begin(), classes.end(), std::back_inserter(holes),
               [](const JudgedClass& judged) { return judged.kind == JudgedClass::Kind::found; });
  return holes;
}

bool is_alive(const JudgedClass& judged, double d) {
  return judged.span.birth < d && d <= judged.span.death;
}

bool accepts(const JudgedClass& judged, double d) {
  return judged.span.birth < d && d <= judged.coarsest();
}

double clear_edge_length(const Filtration& filtration, const Judged& holes) {
  Plateau lowest;
  for (const Plateau& plateau : filtration.plateaus()) {
    const bool holds_all = std::all_of(holes.begin(), holes.end(), [&](const JudgedClass& hole) {
      return hole.span.birth <= plateau.lower && plateau.upper <= hole.span.death &&
             plateau.lower < kCoarsest * hole.span.death;
    });
    const bool is_lower = lowest.loops == 0 || plateau.lower < lowest.lower;
    if (plateau.ratio() >= kClearRatio && holds_all && is_lower &&
        plateau.loops == static_cast<int>(holes.size()))
      lowest = plateau;
  }
  return lowest.loops > 0 ? edge_length_on(lowest, filtration.betti()) : 0;
}

double common_edge_length(const Filtration& filtration, const Judged& holes,
                          const Judged& classes) {
  Plateau scale = common_scale(holes.empty() ? classes : holes);
  const double middle = std::sqrt(scale.lower * scale.upper);
  scale.loops = static_cast<int>(
      std::count_if(classes.begin(), classes.end(),
                    [&](const JudgedClass& judged) { return is_alive(judged, middle); }));
  return edge_length_on(scale, filtration.betti());
}

}  // namespace graspless::geometry
