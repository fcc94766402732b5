// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "graspless/planning/budget.hpp"

namespace graspless::planning {

/// Fills status and reason of a plan that was not found because the clock is out. If the time is
/// over, the status stays. `advice` says what takes less memory.
template <class Plan>
void blame_clock(const Clock& clock, const std::string& advice, Plan& plan) {
  using Status = decltype(plan.status);
  plan.reason = clock.reason();
  if (clock.was_interrupted()) {
    plan.status = Status::interrupted;
  } else if (clock.is_out_of_memory()) {
    plan.status = Status::out_of_memory;
    plan.reason += "; take " + advice;
  }
}

/// Returns the plan of `search`, or why there is none if the clock ended the search from within or
/// memory ran out.
template <class Search>
auto plan_within(Clock& clock, const std::string& advice, const Search& search) {
  decltype(search()) plan;
  const bool has_ended = clock.run([&] { plan = search(); });
  if (plan || (has_ended && !clock.is_out_of_memory())) return plan;
  blame_clock(clock, advice, plan);
  plan.statistics.seconds = clock.seconds();
  return plan;
}

}  // namespace graspless::planning
