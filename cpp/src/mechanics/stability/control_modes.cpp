// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Section 3.4: control modes of the fingers, and the choice among ties.
#include <stdexcept>

#include "graspless/mechanics/stability.hpp"

#include "mechanics/stability/control.hpp"
#include "mechanics/stability/mode_search.hpp"
#include "mechanics/stability/reference.hpp"

namespace graspless::mechanics {
namespace {

using Eigen::Vector3d;

std::vector<FingerMode> modes_of(ForceMask mask, std::size_t fingers) {
  std::vector<FingerMode> modes(fingers, FingerMode::position);
  for (std::size_t i = 0; i < fingers; ++i) {
    if ((mask >> i & 1U) != 0) modes[i] = FingerMode::force;
  }
  return modes;
}

Vector3d direction(const Vector3d& sum) {
  return sum.norm() > 1e-9 ? sum.normalized() : Vector3d::Zero();
}

/// Measures how well modes suit the fingers: force control should press into the environment,
/// position control should be in line with the motion.
double suitability(const ContactSet& set, ForceMask mask) {
  Vector3d support = Vector3d::Zero(), motion = Vector3d::Zero();
  for (const Contact& contact : set.contacts) {
    support += contact.n_O;
    if (contact.mode == ContactMode::slide) motion += tangent(contact.n_O, contact.t_O);
  }
  support = direction(support);
  motion = direction(motion);
  double sum = 0;
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    const Vector3d& n = set.fingers[i].n_O;
    sum += (mask >> i & 1U) != 0 ? -n.dot(support) : std::abs(n.dot(motion));
  }
  return sum;
}

ControlModes choose(const ContactSet& set, const std::vector<FingerMode>& previous,
                    const Matrix6Xd& directions, Engine engine, StabilitySolver& solver) {
  solver.set(set);
  const Reference reference(set);
  const auto evaluate = [&](ForceMask mask) {
    return engine == Engine::fast ? solver.max_stability(mask)
                                  : reference.max_stability(mask, directions);
  };
  const StabilitySolver::Best best =
      engine == Engine::fast
          ? solver.best_control_modes()
          : search_modes(
                static_cast<int>(set.fingers.size()), 0,
                [&](ForceMask mask) { return reference.internal_force_is_bounded(mask); },
                [&](ForceMask mask, double) { return evaluate(mask).z; }, [](ForceMask) {});
  ControlModes modes;
  modes.found = best.found;
  if (!best.found) return modes;
  const ForceMask mask = break_tie(set, best.ties, previous);
  modes.modes = modes_of(mask, set.fingers.size());
  modes.stability = evaluate(mask);
  return modes;
}

void check_previous(const ContactSet& set, const std::vector<FingerMode>& previous) {
  if (previous.empty() || previous.size() == set.fingers.size()) return;
  throw std::invalid_argument(
      "previous must be empty or have " + std::to_string(set.fingers.size()) +
      " entries, one for each finger, not " + std::to_string(previous.size()));
}

}  // namespace

ForceMask break_tie(const ContactSet& set, unsigned ties, const std::vector<FingerMode>& previous) {
  if (previous.size() == set.fingers.size()) {
    const ForceMask kept = force_mask(set, previous);
    if ((ties >> kept & 1U) != 0) return kept;
  }
  ForceMask best = 0;
  double most = -1e300;
  for (ForceMask mask = 0; mask < 1U << set.fingers.size(); ++mask) {
    if ((ties >> mask & 1U) == 0) continue;
    const double suits = suitability(set, mask);
    if (suits <= most + 1e-9) continue;
    most = suits;
    best = mask;
  }
  return best;
}

ControlModes best_control_modes(const ContactSet& set, const std::vector<FingerMode>& previous,
                                const Matrix6Xd& directions, Engine engine) {
  validate(set);
  check_previous(set, previous);
  StabilitySolver solver(directions);
  return choose(set, previous, directions, engine, solver);
}

std::vector<ControlModes> best_control_modes(const std::vector<ContactSet>& sets,
                                             const Matrix6Xd& directions, Engine engine) {
  for (std::size_t i = 0; i < sets.size(); ++i)
    validate(sets[i], "sets[" + std::to_string(i) + "]");
  StabilitySolver solver(directions);
  std::vector<ControlModes> all;
  for (const ContactSet& set : sets) all.push_back(choose(set, {}, directions, engine, solver));
  return all;
}

}  // namespace graspless::mechanics
