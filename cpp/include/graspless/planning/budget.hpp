// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>

#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::planning {

/// All time and randomness of a query; fields() describes them. The same seed and iterations give
/// the same plan, bit by bit, provided the clock does not end the search first.
struct Budget {
  double seconds = 10;
  std::int64_t iterations = std::numeric_limits<std::int64_t>::max();
  std::uint64_t seed = 1;
  /// Ends the query when it returns true. Called at once and then at most every 10 ms, from the
  /// thread that plans.
  std::function<bool()> interrupted;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Budget&) {
  return std::make_tuple(
      Field{"seconds", &Budget::seconds, "s", "Wall-clock time.",
            Range::left_open(0, std::numeric_limits<double>::infinity())},
      Field{"iterations", &Budget::iterations, "",
            "Iterations of the planner's main loop. Default: no limit.", Range::not_negative()},
      Field{"seed", &Budget::seed, "", "Seed of all random numbers.", Range::not_negative()});
}

/// Spends a budget: the clock of one query.
class GRASPLESS_API Clock {
 public:
  /// Throws std::invalid_argument when a field of the budget is out of its range.
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
