// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "graspless/planning/path.hpp"

#include "slide/query.hpp"
#include "slide_peers.hpp"

namespace graspless::benchmarks {

/// A dense path of OMPL's between two configurations of the arm, or nothing within the clock.
std::optional<planning::Path> run_ompl(Peer peer, slide::Query& query, const Eigen::VectorXd& start,
                                       const Eigen::VectorXd& goal, planning::Clock& clock,
                                       std::uint64_t seed);

}  // namespace graspless::benchmarks
