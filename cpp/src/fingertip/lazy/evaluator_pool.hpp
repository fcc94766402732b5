// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Stabilities asked for in batches and solved by several threads.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

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
  EvaluatorPool(std::vector<Evaluator>& evaluators, int threads);
  ~EvaluatorPool();
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
  void help();        // what the other threads do
  void take_lanes();  // solves lanes until none is left
  void solve_lane(std::size_t lane);

  std::vector<Evaluator>& evaluators_;
  std::vector<StabilityQuery>* queries_ = nullptr;
  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::atomic<int> round_{0};
  std::atomic<std::size_t> next_lane_{0}, busy_{0};
  bool shared_ = false;  // the other threads were woken
  std::atomic<bool> stop_{false}, cancelled_{false};
  std::exception_ptr failure_;
};

}  // namespace graspless::fingertip
