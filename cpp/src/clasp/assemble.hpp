// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clasp/query.hpp"
#include "clasp/search/clasp_search.hpp"

namespace graspless::clasp {

/// A clasp of one loop: the path to it with open fingers, and the path of the closing fingers.
struct Clasp {
  planning::Path reach, close;
  geometry::ClaspTarget target_W;
  Stability stability;
  std::optional<Pinch> pinch;
};

/// Closes the fingers until contact and tests the stability. Returns nothing if the clasp is
/// rejected, and counts the reason.
std::optional<Clasp> close_clasp(ClaspSearch& search);

/// Writes a clasp into the plan: prunes the path, and adds rows, virtual linking and the tree.
void assemble(ClaspSearch& search, Clasp clasp, Plan& plan);

/// Writes the statistics into the plan, and a reason if it has none yet.
void conclude(const Query& query, const std::vector<std::unique_ptr<ClaspSearch>>& searches,
              Plan& plan);

}  // namespace graspless::clasp
