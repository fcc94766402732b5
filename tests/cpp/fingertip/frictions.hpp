// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "fingertip/cases.hpp"

/// Plans under other coefficients of friction.
namespace graspless::fingertip {

inline Options five_a_side() {
  Options options;
  options.locations_per_side = 5;
  options.explain = false;
  return options;
}

/// The least stability of the plan's rows, by check(), under certain coefficients: that of planes
/// without their own, then that of each plane with its own, and that of the fingers; 0 when it
/// jams.
inline double stability_at(Problem problem, Plan plan, const Options& options,
                           const std::vector<double>& environment, double fingers) {
  auto coefficient = environment.begin();
  problem.friction = {*coefficient, *coefficient};
  problem.fingers.friction = {fingers, fingers};
  for (Plane& plane : problem.planes) {
    if (!plane.friction) continue;
    ++coefficient;
    plane.friction = {*coefficient, *coefficient};
  }
  for (Segment& segment : plan.segments) {
    for (Row& row : segment.rows) row.stability = 1e9;  // so that each row is said to have less
  }
  double least = 1e9;
  for (const std::string& fault : check(problem, plan, options)) {
    if (fault.find(": modes:") != std::string::npos) return 0;
    const std::string words = ": stability: ";
    const std::size_t at = fault.find(words);
    if (at != std::string::npos)
      least = std::min(least, std::stod(fault.substr(at + words.size())));
  }
  return least;
}

}  // namespace graspless::fingertip
