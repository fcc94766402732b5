// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {

constexpr double kTie = 1e-9;  ///< difference of z that counts as a tie: [N], relative above 1 N

/// Chooses among `ties` (masks as bits): that of `previous` if it is among them, else the one in
/// which force control presses into the environment and position control opposes the motion.
ForceMask break_tie(const ContactSet& set, unsigned ties, const std::vector<FingerMode>& previous);

/// Section 3.4 for any engine. Tries the combinations of control modes, those with fewer fingers in
/// force control first. Once a combination cannot jam, those that add fingers in force control
/// cannot be better. bounded(mask) solves Problem (5). evaluate(mask, needed) solves Problem (6)
/// and returns z, or an upper bound below `needed`. keep(mask) is called whenever that mask is the
/// best so far.
template <typename Bounded, typename Evaluate, typename Keep>
StabilitySolver::Best search_modes(int fingers, double needed, Bounded bounded, Evaluate evaluate,
                                   Keep keep) {
  StabilitySolver::Best best;
  unsigned examined = 0;  // bounded masks, as bits
  const auto dominated = [&](ForceMask mask) {
    for (ForceMask subset = mask; subset > 0;) {
      subset = (subset - 1) & mask;
      if ((examined >> subset & 1U) != 0) return true;
    }
    return false;
  };
  for (int forced = 0; forced <= fingers; ++forced) {
    for (ForceMask mask = 0; mask < 1U << fingers; ++mask) {
      if (__builtin_popcount(mask) != forced || dominated(mask) || !bounded(mask)) continue;
      examined |= 1U << mask;
      const double slack = kTie * std::max(1.0, std::isfinite(best.z) ? best.z : 1.0);
      const double z = evaluate(mask, std::max(needed, best.found ? best.z - slack : 0.0));
      if (z <= 0 || z < needed) {
        if (!best.found) best.z = std::max(best.z, z);
        continue;
      }
      if (best.found && z < best.z - slack) continue;
      if (!best.found || z > best.z + slack) {
        best = {true, mask, z, Eigen::Vector4d::Zero(), 0};
        keep(mask);
      }
      best.ties |= 1U << mask;
    }
  }
  return best;
}

}  // namespace graspless::mechanics
