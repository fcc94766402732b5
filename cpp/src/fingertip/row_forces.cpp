// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Nominal forces of rows, which do not depend on each other.
#include "fingertip/row_forces.hpp"

#include <algorithm>

#include "graspless/watch.hpp"

#include "crew.hpp"
#include "mechanics/equilibrium/springs.hpp"

namespace graspless::fingertip {
namespace {

RowForces forces_of(const RowContacts& row, const Options& options, const mechanics::Yield& yield) {
  const auto& [set, best] = row;
  const auto& directions = options.disturbance_directions;
  RowForces forces;
  const auto springs = mechanics::sprung_along(set, best.modes, options.compliance, directions);
  forces.nominal =
      mechanics::compliant_equilibrium(set, best.modes, best.stability.commanded_forces, springs);
  if (!forces.nominal) return forces;
  forces.compliant_stability = mechanics::compliant_stability(set, *forces.nominal, springs);
  forces.promise = mechanics::promise(set, best.modes, *forces.nominal, options.compliance, yield,
                                      directions, springs);
  return forces;
}

}  // namespace

std::vector<RowForces> forces_of(const std::vector<RowContacts>& rows, const Options& options,
                                 const mechanics::Yield& yield) {
  std::vector<RowForces> forces(rows.size());
  Crew crew(std::min(options.threads, static_cast<int>(rows.size())));
  crew.share(rows.size(), [&](std::size_t i) {
    poll();
    forces[i] = forces_of(rows[i], options, yield);
  });
  return forces;
}

}  // namespace graspless::fingertip
