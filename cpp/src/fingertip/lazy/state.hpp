// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "crew.hpp"
#include "fingertip/lazy/bounds.hpp"
#include "fingertip/lazy/candidates.hpp"
#include "fingertip/lazy/displacements.hpp"
#include "fingertip/lazy/evaluator_pool.hpp"
#include "fingertip/lazy/hubs.hpp"
#include "fingertip/model/pose_graph.hpp"

namespace graspless::fingertip {

/// State that all parts of the lazy search share.
struct LazyState {
  LazyState(const PoseGraph& graph, std::vector<Evaluator>& evaluators, planning::Clock& clock,
            Statistics& statistics, double limit);

  /// Solves the queries, and records the results in bounds, candidates and hubs.
  void solve(std::vector<StabilityQuery>& queries);
  /// The same in three steps. Between them the caller may work, but not call solve().
  void start(std::vector<StabilityQuery>& queries);  // takes them
  void record_last();                                // records the results of those before
  void finish();
  void cancel();               // instead of finish(), when the clock has ended the search
  std::int64_t note_memory();  // of the tables, now [bytes]
  /// Throws std::bad_alloc when the tables have outgrown Options::max_memory.
  void watch_memory();

  static constexpr std::size_t kWatch = 4096;  // placements from one memory check to the next

  const PoseGraph& graph;
  const int count;            // of fingers
  const float min_stability;  // [N]
  planning::Clock& clock;
  Statistics& statistics;
  Crew crew;
  StabilityBounds bounds;
  const Displacements displacements;
  Candidates candidates;
  Hubs hubs;
  std::int64_t unopened = 0;  // placements that wait in the queue
  double limit;               // routes of this cost or more are not searched for [m]

 private:
  void record(const std::vector<StabilityQuery>& queries);
  std::vector<StabilityQuery> in_flight_, solved_;  // solved but not recorded yet
  EvaluatorPool pool_;                              // the first to be destroyed
};

/// One candidate up to a pose and another from there on; if they are the same, without a regrasp.
std::vector<Node> nodes_of(const LazyState& lazy, int first, int second, int pose);

/// The cheapest route with at most one regrasp whose every sample has been solved.
Route best_solved(LazyState& lazy);

/// Lets the first evaluator know what the others have found out about the route.
void share_stabilities(const PoseGraph& graph, const Route& route,
                       std::vector<Evaluator>& evaluators);

/// The cheapest route with at most options.max_regrasps, by dynamic programming over poses,
/// regrasps and placements, solving what is open on the best one until nothing is.
Route search_many_regrasps(LazyState& lazy);

/// Calls found(placement) for all placements on these locations (ascending) for which the bounds at
/// these instants allow the stability `needed`, in lexicographic order, until it returns false.
void for_each_placement(const PoseGraph& graph, const StabilityBounds& bounds, int count,
                        const std::vector<int>& locations, const std::vector<int>& instants,
                        float needed, Crew& crew,
                        const std::function<bool(const Placement&)>& found);

/// Solves a few placements at the instants, until their functionals exclude nearly all placements
/// that can be excluded.
void seed_bounds(LazyState& lazy, const std::vector<int>& locations,
                 const std::vector<int>& instants);

/// Links placements that can carry the object from the start, or to the goal, to their hubs, and
/// ranks these.
void link_ends(LazyState& lazy);

/// Opens all placements that can carry the object along any arc, and links them to their hubs.
void open_all(LazyState& lazy);

/// Locations clear at all poses from `first` to `last`.
std::vector<int> clear_locations(const PoseGraph& graph, int first, int last);

}  // namespace graspless::fingertip
