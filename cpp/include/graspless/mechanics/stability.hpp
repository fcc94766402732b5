// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

/// Who solves the linear programs. Both give the same numbers (to 1e-9).
enum class Engine {
  fast,       ///< decomposed by directions, warm started: stability_solver.hpp
  reference,  ///< the programs as the paper writes them, by GLPK, with checked residuals
};

/// How much disturbance an instant withstands: the answer of Problem (6).
struct Stability {
  /// The largest z such that every z l_i can be balanced [N]; 0 when there is no equilibrium or it
  /// has no margin; infinite when contacts can balance anything (then (5) is unbounded too).
  double z = 0;
  /// f_com [N]: one a finger, 0 for those in position control.
  Eigen::VectorXd commanded_forces;
  /// Columns of the directions that keep z from growing (to 1e-9).
  std::vector<int> binding_directions;
};

/// Problem (6): the stability of a contact set with these control modes, one a finger, over
/// `directions` (6 x N, columns that positively span the space). Throws std::invalid_argument on a
/// bad contact set, modes or directions.
GRASPLESS_API Stability max_stability(const ContactSet& set, const std::vector<FingerMode>& modes,
                                      const Matrix6Xd& directions = disturbance_directions(),
                                      Engine engine = Engine::fast);

/// Problem (5): whether contacts and position-controlled fingers cannot jam: no contact forces of
/// arbitrary size that cancel each other. A contact set without contacts or fingers is bounded.
GRASPLESS_API bool internal_force_is_bounded(const ContactSet& set,
                                             const std::vector<FingerMode>& modes,
                                             Engine engine = Engine::fast);

/// The control modes of greatest stability that cannot jam, Section 3.4.
struct ControlModes {
  bool found = false;  ///< whether any combination is free of jamming and in equilibrium with z > 0
  std::vector<FingerMode> modes;
  Stability stability;
};

/// Searches the combinations of control modes. A combination is passed over when a bounded one with
/// fewer force-controlled fingers exists, since that one is at least as stable. Ties (to 1e-9) of
/// the rest go to `previous` if it is among them, else to force control for the fingers that press
/// into the environment and position control for those that oppose the motion: the other way round
/// is as stable on paper, and flies apart.
GRASPLESS_API ControlModes best_control_modes(
    const ContactSet& set, const std::vector<FingerMode>& previous = {},
    const Matrix6Xd& directions = disturbance_directions(), Engine engine = Engine::fast);

/// The stability of many contact sets, each with its best control modes.
GRASPLESS_API std::vector<ControlModes> best_control_modes(
    const std::vector<ContactSet>& sets, const Matrix6Xd& directions = disturbance_directions(),
    Engine engine = Engine::fast);

}  // namespace graspless::mechanics
