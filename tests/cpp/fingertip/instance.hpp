// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

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

}  // namespace graspless::fingertip
