// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The state of a lazy best-first search over placements.
#pragma once

#include <vector>

#include "fingertip/lazy/candidates.hpp"
#include "fingertip/lazy/hubs.hpp"
#include "fingertip/lazy/lanes.hpp"
#include "fingertip/lazy/supports.hpp"
#include "fingertip/model/path_query.hpp"

namespace graspless::fingertip {

/// What all parts of the search share.
struct FastSearch {
  FastSearch(const PathQuery& query, std::vector<Evaluator>& evaluators, planning::Clock& clock,
             Statistics& statistics, double limit);

  /// Solves the questions, and hands what came of them to bounds, candidates and hubs.
  void solve(std::vector<Question>& questions);
  /// The same in three steps: meanwhile something else may be done, but for solve().
  void start(std::vector<Question>& questions);  // takes them
  void learn_last();                             // hands on what came of those before
  void finish();
  std::int64_t note_memory(std::int64_t more_candidates = 0);  // of the tables, now [bytes]
  /// Throws std::length_error when the tables have outgrown Options::max_memory.
  void watch_memory(std::int64_t more_candidates = 0);

  static constexpr std::size_t kWatch = 4096;  // placements from one look to the next

  const PathQuery& query;
  const int count;  // of fingers
  planning::Clock& clock;
  Statistics& statistics;
  Supports supports;
  Candidates candidates;
  Hubs hubs;
  std::int64_t unopened = 0;      // placements that wait in the frontier
  double least_displacement = 0;  // no route costs less, whatever its placements
  double limit;                   // routes of this cost or more are not looked for

 private:
  void learn(const std::vector<Question>& questions);
  std::vector<Question> in_flight_, solved_;  // solved and not handed on yet
  Lanes lanes_;                               // the first to be destroyed
};

/// Solves a few placements at the instants, until their functionals refuse nearly all that can be
/// refused.
void seed_supports(FastSearch& search, const std::vector<int>& locations,
                   const std::vector<int>& instants);

/// Opens all placements that the bounds allow at the instants.
void open_all(FastSearch& search, const std::vector<int>& locations,
              const std::vector<int>& instants);

/// Locations clear at all poses from `first` to `last`.
std::vector<int> clear_locations(const PathQuery& query, int first, int last);

/// One candidate up to a pose and another from there on; the same one, and no regrasp.
std::vector<Node> nodes_of(const FastSearch& search, int first, int second, int pose);

/// The cheapest route: those with at most one regrasp best first, then search_layers().
Route search_best_first(FastSearch& search);

/// The cheapest route with at most `max_regrasps`, by dynamic programming over poses, regrasps and
/// placements, solving what is open on the best one until nothing is.
Route search_layers(FastSearch& search, int max_regrasps);

}  // namespace graspless::fingertip
