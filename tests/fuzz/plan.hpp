// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>
#include <string>
#include <vector>

#include "graspless/planning/budget.hpp"

#include "fuzz/bytes.hpp"

namespace graspless::fuzz {

inline planning::Budget small_budget(Bytes& bytes, std::int64_t iterations) {
  planning::Budget budget;
  budget.seconds = 0.03;  // most plans are found in less
  budget.iterations = bytes.chance(2) ? iterations : bytes.whole(0, 10);
  budget.seed = bytes.byte();
  return budget;
}

/// Plans and checks the plan. The laws: a refusal or a status, in the budget's time with set-up,
/// and no fault in a plan that was found. Processor time does not depend on other programs; the
/// slack is for sanitizers, which slow set-up down.
template <typename Problem, typename Options>
void require_plan(const Problem& problem, const Options& options, const planning::Budget& budget) {
  constexpr double kSlack = 2;  // [s]
  const std::clock_t start = std::clock();
  const auto found = plan(problem, options, budget);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  require(seconds <= budget.seconds + kSlack,
          "the budget holds, but took " + std::to_string(seconds) + " s");
  if (!found) {
    require(!found.reason.empty(), "a failure has a reason");
    return;
  }
  const std::vector<std::string> faults = check(problem, found, options);
  require(faults.empty(), "a plan holds, but: " + (faults.empty() ? "" : faults.front()));
}

}  // namespace graspless::fuzz
