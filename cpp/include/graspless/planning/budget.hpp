// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <new>
#include <optional>
#include <string>

#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"
#include "graspless/watch.hpp"

namespace graspless::planning {

/// All time and randomness of a query; fields() describes them. The same seed and iterations give
/// the same plan, bit by bit, provided the clock does not end the search first.
struct Budget {
  double seconds = 10;
  std::int64_t iterations = std::numeric_limits<std::int64_t>::max();
  std::uint64_t seed = 1;
  /// Ends the query when it returns true. Called at once, then at most every 4 ms and before large
  /// allocations, from the thread that plans. It must not call graspless: the query may hold a lock
  /// that such a call would wait for.
  std::function<bool()> interrupted = {};
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

/// Spends a budget: the clock of one query, and its limit of memory.
class GRASPLESS_API Clock {
 public:
  /// `max_memory`: how much the process may grow while the query runs [bytes]. Throws
  /// std::invalid_argument when a field of the budget is out of its range.
  explicit Clock(const Budget& budget, double max_memory = std::numeric_limits<double>::infinity());

  bool spend();   ///< counts one iteration; false if the budget is used up
  bool is_out();  ///< true if time or memory is up or the query was interrupted; counts nothing
  bool ran_out() { return refused_ || is_out(); }  ///< the same, or spend() was false once
  bool was_interrupted() const { return interrupted_; }
  bool is_out_of_memory() const { return out_of_memory_; }
  double seconds() const;  ///< since construction
  std::int64_t iterations() const { return iterations_; }
  std::string reason() const;  ///< of a query that ended without a plan because the clock was out
  std::string note() const;    ///< for the reason of a search that the time ended; otherwise empty

  /// Runs `work` and returns true; or false if poll() ended it. That happens when the clock is out
  /// and the loops that ask is_out() have not ended the work soon, or memory cannot be allocated.
  /// Calls may nest.
  template <class Work>
  bool run(const Work& work) {
    const Watch watch([this] { require(); });
    try {
      work();
      return true;
    } catch (const Stop&) {
      if (!out_since_) throw;  // of a Watch of the caller
    } catch (const std::bad_alloc&) {
      out_of_memory_ = true;
    }
    out_since_ = Steady::now();  // once more time to conclude with what was found
    return false;
  }

  /// Same for work that writes up what was found. After the time is over, it may take 40 ms more,
  /// and 10 ms more for each of its `rows`. Signals and memory end it as they end a search.
  template <class Work>
  bool conclude(const Work& work, std::size_t rows = 0) {
    concluding_ = rows;
    const struct Guard {
      std::optional<std::size_t>& concluding;
      ~Guard() { concluding.reset(); }
    } guard{concluding_};
    const bool has_ended = run(work);
    if (out_since_) out_since_ = Steady::now();  // time for the rest, too
    return has_ended;
  }

 private:
  using Steady = std::chrono::steady_clock;
  void require();      // throws Stop
  void look_if_due();  // at signals and memory, every 4 ms
  void look();

  Budget budget_;
  double max_memory_;
  Steady::time_point start_, next_poll_;
  std::optional<Steady::time_point> out_since_;
  std::optional<double> memory_at_start_;  // at the first look [bytes]
  std::int64_t iterations_ = 0;
  bool refused_ = false;  // an iteration
  bool interrupted_ = false;
  bool out_of_memory_ = false;
  std::optional<std::size_t> concluding_;  // number of rows
};

}  // namespace graspless::planning
