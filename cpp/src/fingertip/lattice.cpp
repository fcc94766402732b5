// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Slides and turns through a lattice of poses in the plane.
#include <stdexcept>

#include "fingertip/assemble.hpp"
#include "fingertip/lattice_search.hpp"
#include "fingertip/motions.hpp"

namespace graspless::fingertip {
namespace {

std::vector<Stage> stages_of(const LatticeSpace& space, const Route& route) {
  std::vector<Stage> stages;
  for (const Node& node : route.nodes) {
    if (stages.empty() || stages.back().placement != node.placement) {
      stages.push_back({node.placement, {}});
    }
    stages.back().X_WO.push_back(space.X_WO(node.pose));
  }
  return stages;
}

}  // namespace

Plan plan_lattice(Workshop& workshop, const Lattice& lattice, planning::Clock& clock) {
  Plan plan;
  LatticeSpace space(workshop, lattice);
  if (space.start() == space.goal()) {
    throw std::invalid_argument("motion.X_WO_goal must differ from motion.X_WO_start");
  }
  LatticeBounds bounds(workshop);
  const Route route = search_placements(workshop, space, bounds, clock, plan.statistics);
  plan.statistics.supports = bounds.count();
  plan.statistics.memory = space.memory() + bounds.memory();
  plan.lower_bound = route.lower_bound;
  if (!route.found) return plan;
  plan.status = Status::solved;
  assemble(stages_of(space, route), workshop.locations, workshop.instants,
           workshop.evaluators.front(), plan);
  return plan;
}

}  // namespace graspless::fingertip
