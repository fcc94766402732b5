// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "graspless/fingertip/fingertip.hpp"
#include "graspless/mechanics/friction_interval.hpp"

#include "fingertip/model/instants.hpp"

namespace graspless::fingertip {

/// Where and how a plan fails for a coefficient within the problem's friction intervals.
struct FrictionFailure {
  int segment, row;
  mechanics::FrictionVerdict verdict;
};

/// Looks at every distinct instant of a plan with its modes and commanded forces; nothing when all
/// hold for every coefficient. Whether an instant is new is told by the number that `instants`
/// gives it.
std::optional<FrictionFailure> find_friction_failure(const Problem& problem, const Options& options,
                                                     Instants& instants, const Plan& plan);

/// Searches until the plan holds for all coefficients in the intervals: each that it fails for is
/// looked at from then on by `instants`, beside the ends, and the search run anew. When that does
/// not come to an end, the plan is `unstable` and its reason says that the search gave up, and
/// names the last such coefficient: a plan may exist. Of friction that is known exactly, this is
/// one search.
Plan plan_over_friction(const Problem& problem, const Options& options, Instants& instants,
                        const std::function<Plan()>& search);

}  // namespace graspless::fingertip
