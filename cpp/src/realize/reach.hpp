// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Motions that are free to choose their way: home to the first grip, and a finger to its next place
// while the others hold.
#pragma once

#include <optional>
#include <random>

#include "graspless/planning/budget.hpp"
#include "graspless/planning/path.hpp"

#include "realize/track.hpp"

namespace graspless::fingertip {

/// Rows from one configuration to another while the object stands where the scene has it and the
/// fingers in held.held stay at held.p_WT (none held: any free motion). Contacts are as last set.
/// Nothing when `iterations` of the tree search found no way.
std::optional<planning::Path> reach(Hand& hand, const TipTargets& held, const Eigen::VectorXd& from,
                                    const Eigen::VectorXd& to, int iterations,
                                    planning::Clock& clock, std::mt19937_64& rng);

}  // namespace graspless::fingertip
