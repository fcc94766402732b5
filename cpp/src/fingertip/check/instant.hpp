// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Eqs. (1) to (6) written out as small linear programs, one a question.
#pragma once

#include <optional>
#include <vector>

#include "graspless/mechanics/friction_interval.hpp"
#include "graspless/mechanics/stability.hpp"

#include "mechanics/lp/basis.hpp"
#include "mechanics/lp/program.hpp"

namespace graspless::fingertip::checking {

/// Contacts and the fingers that touch, with the modes and forces that a plan gives them.
struct Instant {
  mechanics::ContactSet set;  // friction at the lower ends
  mechanics::Surfaces surfaces;
  std::vector<mechanics::FingerMode> modes;
  Eigen::VectorXd commanded_forces;
};

/// True if two instants are the same but for rounding.
bool is_near(const Instant& a, const Instant& b, double length, double force);

/// End of an interval of friction.
using End = double mechanics::FrictionInterval::*;

/// The contacts of an instant with friction at these ends.
mechanics::ContactSet with_friction(const Instant& instant, End slide, End stick, double fingers);

/// Problem (6) with f_com fixed, without l_d. Column 0 is z, the next ones are k_env, then k_rob.
/// Rows 0 ... 5:
///   z l_d - R^1/2 (W_env C_env k_env + W_rob C_rob k_rob) = R^1/2 Q_known;
/// then one for each finger: N^T C_rob k_rob, at most f_max or equal to f_com.
mechanics::LinearProgram balance(const Instant& instant);

/// Margin of given finger forces: the largest t such that some contact forces complete them to an
/// equilibrium (residual at most `tolerance` [N, scaled]) with every cone coefficient, fingers'
/// too, at least t. Empty if there is none with t >= 0, but for the tolerance. `basis` is where the
/// search begins, and then where it has ended.
std::optional<double> margin_of(const Instant& instant, const Eigen::Matrix3Xd& finger_forces_O,
                                double tolerance, mechanics::LpBasis& basis);

}  // namespace graspless::fingertip::checking
