// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "fingertip/model/evaluator.hpp"
#include "fingertip/model/pose_graph.hpp"

namespace graspless::fingertip {

/// With so many evaluators the result is the same whatever the number of threads.
constexpr int kPoolSize = 8;

/// Lazy best-first search over the placements of a path: the same cost as search_graph(), with as
/// few stabilities evaluated as the proof of optimality needs. Routes of `limit` or more are not
/// searched for: complete and not found means that there is none below. With `needs_regrasp`, it is
/// known that there is no route without a regrasp. Afterwards the first
/// evaluator knows the stabilities of the route. Throws std::bad_alloc when the tables outgrow
/// Options::max_memory.
Route search_fast(const PoseGraph& graph, std::vector<Evaluator>& evaluators,
                  planning::Clock& clock, Statistics& statistics,
                  double limit = std::numeric_limits<double>::infinity(),
                  bool needs_regrasp = false);

}  // namespace graspless::fingertip
