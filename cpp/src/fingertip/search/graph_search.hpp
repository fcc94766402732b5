// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>

#include "fingertip/model/evaluator.hpp"
#include "fingertip/model/pose_graph.hpp"
#include "fingertip/search/heuristic.hpp"

namespace graspless::fingertip {

/// Costs (9) of arcs with the fingers at a placement, for a search.
class ArcCosts {
 public:
  virtual ~ArcCosts() = default;
  /// Cost of an arc, or a lower bound of it until it is settled; infinite if it is impossible.
  virtual double cost(int pose, int move, const Placement& placement) = 0;
  /// The cost itself.
  virtual double settle(int pose, int move, const Placement& placement) = 0;
};

/// Settings of a search. The defaults make the search exact.
struct GraphSearch {
  bool heuristic = true;  // A* with (11); else Dijkstra's search
  /// Lazy costs: settled when an arc turns out to be the best to its end. Null: arcs are evaluated
  /// when they are reached.
  ArcCosts* lazy = nullptr;
  /// Displacements for the heuristic, to be shared between searches; null: own ones.
  RemainingDistance* remaining = nullptr;
  /// Routes of this cost or more are not searched for.
  double limit = std::numeric_limits<double>::infinity();
  /// Above 1: the heuristic is the remaining displacement times this, so that some route is found
  /// soon; neither its cost nor lower_bound are proven then.
  double greed = 1;
  double regrasp_cost = -1;  // that a greedy search reckons with [m]; negative: X_regr
  std::size_t max_nodes = std::numeric_limits<std::size_t>::max();
};

/// Searches the manipulation-feasibility graph (Section 4), regrasps included. Complete and not
/// found: there is no route below the limit. In a lattice, the friction cones of a regrasp lie
/// along the motion that goes on from there, which the search does not know when it comes to it:
/// where the fingers kept then turn out not to hold the object, that regrasp is excluded and the
/// search repeated; the result is not complete any more. Throws std::bad_alloc when the tables
/// outgrow Options::max_memory.
Route search_graph(const PoseGraph& graph, Evaluator& evaluator, const GraphSearch& settings,
                   planning::Clock& clock, Statistics& statistics);

}  // namespace graspless::fingertip
