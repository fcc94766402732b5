// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>

#include "graspless/export.hpp"

namespace graspless::planning {

/// Limits of a query in time and iterations, and its random seed. The same seed and iterations give
/// the same plan, bit by bit, unless time runs out first.
struct Budget {
  double seconds = 10;                                                 ///< wall clock [s]
  std::int64_t iterations = std::numeric_limits<std::int64_t>::max();  ///< rounds of the main loop
  std::uint64_t seed = 1;
  /// Ends the query once it returns true. Called at the start and then at most every 10 ms, from
  /// the thread that plans.
  std::function<bool()> interrupted;
};

/// The clock of one query; counts what it has used of its budget.
class GRASPLESS_API Clock {
 public:
  /// Throws std::invalid_argument unless seconds is positive (infinity is allowed) and iterations
  /// is not negative.
  explicit Clock(const Budget& budget);

  bool spend();   ///< counts one iteration; false if the budget is used up
  bool is_out();  ///< true if time is up or the query was interrupted; counts nothing
  bool was_interrupted() const { return interrupted_; }
  double seconds() const;  ///< since construction
  std::int64_t iterations() const { return iterations_; }

 private:
  using Steady = std::chrono::steady_clock;
  Budget budget_;
  Steady::time_point start_, next_poll_;
  std::int64_t iterations_ = 0;
  bool interrupted_ = false;
};

}  // namespace graspless::planning
