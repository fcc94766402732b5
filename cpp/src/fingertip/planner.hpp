// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "fingertip/model/evaluator.hpp"
#include "fingertip/model/path_query.hpp"

namespace graspless::fingertip {

/// What every kind of motion needs: the lattice of locations, the instants met so far, an evaluator
/// a thread. Problem and options must outlive it.
struct Workshop {
  Workshop(const Problem& problem, const Options& options);

  const Problem& problem;
  const Options& options;
  Locations locations;
  Instants instants;
  std::vector<Evaluator> evaluators;
};

/// Searches a path by the engine of the options, which does not look for routes of `limit`
/// or more.
Route search(const PathQuery& query, Workshop& workshop, planning::Clock& clock,
             Statistics& statistics, double limit = std::numeric_limits<double>::infinity());

/// plan() without validation and explanation; what explain() asks with other values.
Plan solve(const Problem& problem, const Options& options, planning::Clock& clock);

/// Counters of the evaluators, and the time.
void count(const Workshop& workshop, const planning::Clock& clock, Statistics& statistics);

/// What a plan that was not found is to say: the first pose at which geometry allows no placement.
void explain_failure(const PathQuery& query, const Route& route, planning::Clock& clock,
                     Plan& plan);

}  // namespace graspless::fingertip
