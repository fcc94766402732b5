// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fingertip/model/evaluator.hpp"
#include "fingertip/model/instants.hpp"
#include "fingertip/model/locations.hpp"
#include "fingertip/model/pose_graph.hpp"

namespace graspless::fingertip {

/// The fingers stay on the object while it passes through these poses: one pose or more. From one
/// stage to the next the object stays where it is and one finger moves.
struct Stage {
  Placement placement;
  std::vector<Eigen::Isometry3d> X_WO;
};

/// A route of the manipulation-feasibility graph as stages.
std::vector<Stage> stages_of(const PoseGraph& graph, const Route& route);

/// Fills a plan's segments, rows, cost, weakest row, regrasps and warnings. The cost is computed
/// anew by (9) and (10). A stage that carries the object along different ways (slide, turn, tumble)
/// becomes several segments.
void assemble(const std::vector<Stage>& stages, const Locations& locations, Instants& instants,
              Evaluator& evaluator, Plan& plan);

}  // namespace graspless::fingertip
