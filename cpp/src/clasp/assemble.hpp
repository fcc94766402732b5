// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clasp/search/loop_search.hpp"
#include "clasp/query.hpp"

namespace graspless::clasp {

/// What the search found for one loop: the way to the open clasp, and the fingers' closing.
struct Found {
  planning::Path reach, close;
  geometry::ClaspTarget target_W;
  Stability stability;
};

/// The fingers close until contact, and the stability test; counts what is refused.
std::optional<Found> close_clasp(Query& query, LoopSearch& search);

/// Writes a clasp into the plan: path pruning, rows, virtual linking, the tree.
void assemble(Query& query, const LoopSearch& search, Found found, Plan& plan);

/// Counters, and the reason if there is none yet.
void conclude(const Query& query, const std::vector<std::unique_ptr<LoopSearch>>& searches,
              Plan& plan);

}  // namespace graspless::clasp
