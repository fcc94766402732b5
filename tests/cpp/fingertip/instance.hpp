// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "fingertip/planner.hpp"
#include "fingertip/search/graph_search.hpp"

namespace graspless::fingertip {

/// A path with all that a search of it needs.
struct Instance {
  Instance(Problem problem_in, Options options_in)
      : problem(std::move(problem_in)),
        options(std::move(options_in)),
        locations(problem.object, problem.fingers, options),
        instants(problem, options),
        graph(problem, std::get<Path>(problem.motion), locations, instants, options),
        evaluator(instants, locations, options) {}

  Route search(bool heuristic, const planning::Budget& budget = {}) {
    planning::Clock clock(budget);
    GraphSearch settings;
    settings.heuristic = heuristic;
    return search_graph(graph, evaluator, settings, clock, statistics);
  }

  Problem problem;
  Options options;
  Locations locations;
  Instants instants;
  PoseGraph graph;
  Evaluator evaluator;
  Statistics statistics;
};

/// A block pushed 10 cm aside, 6 cm on and round by 0.6 rad, anywhere on a lattice of SE(2).
inline Problem lattice_problem() {
  Lattice lattice;
  lattice.X_WO_start = Eigen::Isometry3d(Eigen::Translation3d(0.2, 0.1, 0.025));
  lattice.X_WO_goal = lattice.X_WO_start;
  lattice.X_WO_goal.pretranslate(Eigen::Vector3d(0.1, 0.06, 0));
  lattice.X_WO_goal.rotate(Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()));
  lattice.lower << -0.02, -0.02, -0.1;
  lattice.upper << 0.12, 0.08, 0.7;
  lattice.counts = {8, 6, 9};
  return {Object::box("block", {0.05, 0.06, 0.05}, 1), {}, {Plane{}}, {0.5, 0.5}, lattice, {}};
}

/// The graph of that problem.
struct LatticeInstance {
  explicit LatticeInstance(int locations_per_side) : options(with_locations(locations_per_side)) {}

  static Options with_locations(int per_side) {
    Options options;
    options.locations_per_side = per_side;
    return options;
  }

  Problem problem = lattice_problem();
  Options options;
  SearchContext context{problem, options};
  PoseGraph graph{problem, std::get<Lattice>(problem.motion), context.locations, context.instants,
                  options};
};

}  // namespace graspless::fingertip
