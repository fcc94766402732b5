// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Memory that a search needs at least, estimated from counts before anything is built.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <variant>

#include "fingertip/planner.hpp"

namespace graspless::fingertip {
namespace {

/// Least memory of a search over so many locations [bytes].
double memory_needed(const Problem& problem, const Options& options, double num_locations) {
  const auto* path = std::get_if<Path>(&problem.motion);
  const double poses = path != nullptr ? static_cast<double>(path->X_WO.size()) : 1;
  const double tables =
      num_locations * (400 + 56.0 * options.cone_edges + poses * (1 + sizeof(double)));
  // The graph's searches open every placement at the start; the fast one weighs pairs.
  const int together =
      options.search == Search::fast ? std::min(problem.fingers.count, 2) : problem.fingers.count;
  double placements = 1;
  for (int i = 0; i < together; ++i) placements *= (num_locations - i) / (i + 1);
  return tables + std::max(placements, 0.0) * (options.search == Search::fast ? 16 : 72);
}

std::string lack_for_lattice(const Problem& problem, const Options& options, double locations) {
  const auto* lattice = std::get_if<Lattice>(&problem.motion);
  const double bytes = lattice != nullptr ? PoseGraph::memory_needed(*lattice, locations) : 0;
  if (bytes <= options.max_memory) return "";
  std::ostringstream text;
  text << "motion.counts: the lattice would need " << bytes / 1e9
       << " GB, more than options.max_memory = " << options.max_memory / 1e9
       << " GB: take smaller counts";
  return text.str();
}

}  // namespace

std::string lack_of_memory(const Problem& problem, const Options& options) {
  const double locations = num_grid_points(problem.object, options);
  const std::string lattice = lack_for_lattice(problem, options, locations);
  if (!lattice.empty()) return lattice;
  const double bytes = memory_needed(problem, options, locations);
  if (bytes <= options.max_memory) return "";
  std::ostringstream text;
  text << "options: " << locations << " fingertip locations for " << problem.fingers.count
       << " fingers need " << std::ceil(bytes / 1e6)
       << " MB, more than options.max_memory = " << options.max_memory / 1e6
       << " MB: take a smaller locations_per_side or a larger location_spacing";
  return text.str();
}

}  // namespace graspless::fingertip
