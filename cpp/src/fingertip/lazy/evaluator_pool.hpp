// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Stabilities asked for in batches and solved by several threads.
#pragma once

#include <optional>
#include <vector>

#include "crew.hpp"
#include "fingertip/model/evaluator.hpp"

namespace graspless::fingertip {

/// A stability that the search wants to know, and what came of it.
struct StabilityQuery {
  enum class Of { candidate, hub };
  Of of = Of::candidate;
  int index = -1;  // of the candidate or hub
  int slot = -1;   // which of its instants
  int instant = -1;
  Placement placement = kNoFingers;
  double needed = 0;  // below it, an upper bound on z is enough

  double z = 0;
  std::vector<mechanics::Vector6d> functionals;
};

/// Shares a batch among the evaluators: query i goes to evaluator i modulo their number,
/// whatever the number of threads, so that answers do not depend on it.
class EvaluatorPool {
 public:
  EvaluatorPool(std::vector<Evaluator>& evaluators, Crew& crew)
      : evaluators_(evaluators), crew_(crew) {}
  ~EvaluatorPool() { cancel(); }
  EvaluatorPool(const EvaluatorPool&) = delete;
  EvaluatorPool& operator=(const EvaluatorPool&) = delete;

  /// Begins to solve on the other threads; the queries must stay until finish().
  void start(std::vector<StabilityQuery>& queries);
  /// Solves what is left and waits for the rest.
  void finish();
  /// Leaves the rest of the batch unsolved, and waits for the queries that other threads have
  /// begun.
  void cancel();

 private:
  void solve_lane(std::vector<StabilityQuery>& queries, std::size_t lane);

  std::vector<Evaluator>& evaluators_;
  Crew& crew_;
  std::optional<Crew::Job> job_;  // the batch, one item for each evaluator
};

}  // namespace graspless::fingertip
