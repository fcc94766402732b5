// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "clasp/query.hpp"

namespace graspless::clasp {

/// A loop with the places where it shall be clasped: gamma and G_gamma of the paper.
struct LoopTargets {
  int loop;         ///< index of object.loops().loops
  Options options;  ///< derived for this loop
  Eigen::Matrix3Xd points_W;
  std::vector<geometry::ClaspTarget> targets_W;  ///< the best first
};

/// The loops and places worth trying, the best first: those in the arm's reach, good for the pull
/// if there is one, near the user's marks if there are any; places with room for a finger all round
/// before others. When none is left, says so in `plan`: status and reason.
std::vector<LoopTargets> choose_targets(Query& query, const Eigen::VectorXd& q, Plan& plan);

}  // namespace graspless::clasp
