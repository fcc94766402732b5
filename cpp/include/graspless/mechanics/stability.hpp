// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

/// Solver of the linear programs. Both give the same z, to 1e-9 of z or 1e-12 of the forces
/// involved.
enum class Engine {
  fast,       ///< decomposed by directions and warm-started; ill-conditioned sets go to `reference`
  reference,  ///< the programs as the paper writes them, solved by GLPK, with checked residuals
};

/// Largest disturbance that a contact set withstands: the answer to Problem (6).
struct Stability {
  /// Largest z such that every z l_i can be balanced [N]. 0 if there is no equilibrium or it has no
  /// margin; infinite if the contacts can balance anything (then (5) is unbounded too).
  double z = 0;
  /// f_com: normal force of each finger, 0 for fingers in position control [N].
  Eigen::VectorXd commanded_forces;
  /// Columns of the directions that limit z (to 1e-9).
  std::vector<int> binding_directions;
};

/// Problem (6): stability of a contact set with one control mode for each finger, over `directions`
/// (6 x N, columns that positively span the space). Throws std::invalid_argument on a bad contact
/// set, modes or directions.
GRASPLESS_API Stability max_stability(const ContactSet& set, const std::vector<FingerMode>& modes,
                                      const Matrix6Xd& directions = disturbance_directions(),
                                      Engine engine = Engine::fast);

/// Problem (5): returns true if contacts and position-controlled fingers cannot jam, that is, if no
/// contact forces of arbitrary size cancel each other. A set without contacts and fingers cannot
/// jam. Throws std::invalid_argument on a bad contact set or modes.
GRASPLESS_API bool internal_force_is_bounded(const ContactSet& set,
                                             const std::vector<FingerMode>& modes,
                                             Engine engine = Engine::fast);

/// Control modes of greatest stability that cannot jam, Section 3.4.
struct ControlModes {
  bool found = false;  ///< true if some combination cannot jam and has z > 0
  std::vector<FingerMode> modes;
  Stability stability;
};

/// Searches the combinations of control modes, Section 3.4. A combination is skipped if a bounded
/// one with a subset of its force-controlled fingers exists, since that one is at least as stable.
/// Ties (to 1e-9) go to `previous` if it is among them. Otherwise force control goes to fingers
/// that press into the environment and position control to fingers that oppose the motion: the
/// opposite is as stable in theory, but an object held that way slips out at the slightest error.
/// Throws std::invalid_argument on bad arguments.
GRASPLESS_API ControlModes best_control_modes(
    const ContactSet& set, const std::vector<FingerMode>& previous = {},
    const Matrix6Xd& directions = disturbance_directions(), Engine engine = Engine::fast);

/// The same for many contact sets, each on its own.
GRASPLESS_API std::vector<ControlModes> best_control_modes(
    const std::vector<ContactSet>& sets, const Matrix6Xd& directions = disturbance_directions(),
    Engine engine = Engine::fast);

}  // namespace graspless::mechanics
