// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A motion of one degree of freedom laid out for search: instants of its samples, where fingertips
// are clear, how far they move.
#include "fingertip/model/path_query.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "fingertip/model/clearance.hpp"
#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {
namespace {

/// Adds a state's instant; a complaint says at which pose it is.
int add_at(Instants& instants, const mechanics::BodyState& state, std::size_t pose,
           const char* where) {
  try {
    return instants.add(state);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) + " (" + where + " pose " +
                                std::to_string(pose) + ")");
  }
}

}  // namespace

PathQuery::PathQuery(const Problem& problem, const Path& path, const Locations& locations_in,
                     Instants& all_instants, const Options& options_in)
    : options(options_in),
      locations(locations_in),
      num_fingers(problem.fingers.count),
      X_WO(path.X_WO) {
  const int P = options.samples_per_arc;
  for (std::size_t i = 0; i + 1 < X_WO.size(); ++i) {
    twist_O.push_back(screw_between(X_WO[i], X_WO[i + 1]));
    for (int j = 0; j < P; ++j) {
      const Eigen::Isometry3d X_WO_j = along_screw(X_WO[i], twist_O[i], (j + 0.5) / P);
      instants.push_back(add_at(all_instants, moving_state(X_WO_j, twist_O[i]), i, "after"));
    }
    for (int l = 0; l < locations.size(); ++l) {
      displacements.push_back(sphere_speed(twist_O[i], locations[l]) / P);
    }
  }
  Clearance clearance(problem);
  for (std::size_t i = 0; i < X_WO.size(); ++i) {
    const mechanics::Vector6d& twist = twist_O[std::min(i, twist_O.size() - 1)];
    rest_instants.push_back(add_at(all_instants, resting_state(X_WO[i], twist), i, "at"));
    for (int l = 0; l < locations.size(); ++l) {
      clear.push_back(clearance.is_clear(X_WO[i] * locations[l].center_O) ? 1 : 0);
    }
  }
}

int PathQuery::instant(int arc, int sample) const {
  return instants[static_cast<std::size_t>(arc * options.samples_per_arc + sample)];
}

int PathQuery::rest_instant(int pose) const {
  return rest_instants[static_cast<std::size_t>(pose)];
}

bool PathQuery::is_clear(int pose, int location) const {
  const auto row = static_cast<std::size_t>(pose) * static_cast<std::size_t>(locations.size());
  return clear[row + static_cast<std::size_t>(location)] != 0;
}

double PathQuery::displacement(int arc, int location) const {
  const auto row = static_cast<std::size_t>(arc) * static_cast<std::size_t>(locations.size());
  return displacements[row + static_cast<std::size_t>(location)];
}

bool is_feasible(const PathQuery& query, int pose, const Placement& placement) {
  const int count = num_fingers(placement);
  for (int i = 0; i < count; ++i) {
    const int a = placement[static_cast<std::size_t>(i)];
    if (!query.is_clear(pose, a)) return false;
    for (int j = 0; j < i; ++j) {
      if (!query.locations.are_apart(a, placement[static_cast<std::size_t>(j)])) return false;
    }
  }
  return true;
}

double arc_cost(const PathQuery& query, int arc, const Placement& placement, const double* z) {
  double weight = 0;
  for (int j = 0; j < query.options.samples_per_arc; ++j) {
    if (!(z[j] > 0)) return std::numeric_limits<double>::infinity();
    weight += 1 + query.options.stability_weight / z[j];
  }
  double displacement = 0;
  for (int i = 0; i < num_fingers(placement); ++i) {
    displacement =
        std::max(displacement, query.displacement(arc, placement[static_cast<std::size_t>(i)]));
  }
  return displacement * weight;  // (9): every finger moves evenly
}

int num_regrasps(const Route& route) {
  int count = 0;
  for (std::size_t i = 1; i < route.nodes.size(); ++i) {
    if (route.nodes[i].pose == route.nodes[i - 1].pose) ++count;
  }
  return count;
}

}  // namespace graspless::fingertip
