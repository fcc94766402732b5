// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "clasp/query.hpp"

namespace graspless::clasp {

/// A loop with its clasp targets: gamma and G_gamma of Stork 2013, Section IV-A.
struct LoopTask {
  int loop;                                      ///< index in object.loops().found
  Options options;                               ///< derived for this loop
  Eigen::Matrix3Xd points_W;                     ///< corners of the loop, 3 x n [m]
  std::vector<geometry::ClaspTarget> targets_W;  ///< best first
};

/// Selects the loops and targets to try, best first: targets in the arm's reach, suitable for the
/// pull if there is one, and nearest to the user's marks if there are any. Targets with room for a
/// finger all round come first. If none is left, sets status and reason of the plan.
std::vector<LoopTask> choose_targets(Query& query, const Eigen::VectorXd& q, Plan& plan);

/// Indices of the loops that may be clasped.
std::vector<int> allowed_loops(const Problem& problem);
/// The allowed loop that is nearest to a mark; of several, the first.
int marked_loop(const Problem& problem, const Eigen::Vector3d& mark);

}  // namespace graspless::clasp
