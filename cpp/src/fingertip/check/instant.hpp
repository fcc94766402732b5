// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "graspless/fingertip/problem.hpp"
#include "graspless/mechanics/equilibrium.hpp"
#include "graspless/mechanics/friction_interval.hpp"
#include "graspless/mechanics/stability.hpp"

/// The mechanics of one instant as check() sees it: Eqs. (1) to (6) written out as small linear
/// programs, one a question.
namespace graspless::fingertip::checking {

/// Contacts and the fingers that touch, with the modes and forces that a plan gives them.
struct Instant {
  mechanics::ContactSet set;  // friction at the lower ends
  std::vector<mechanics::FingerMode> modes;
  Eigen::VectorXd commanded_forces;
};

/// Whether two instants are the same but for rounding.
bool is_near(const Instant& a, const Instant& b, double length, double force);

/// The same contacts under other coefficients of friction.
mechanics::ContactSet with_friction(mechanics::ContactSet set, double slide, double stick,
                                    double fingers);

/// Problem (6) with f_com fixed: the least over the directions l_d of the largest z with z l_d in
/// balance; 0 without an equilibrium.
double stability_at(const Instant& instant, const mechanics::Matrix6Xd& directions);

/// How well given finger forces balance an instant: the largest t such that some contact forces
/// complete them to an equilibrium (residual at most `tolerance` [N, scaled]) with every cone
/// coefficient, fingers' too, at least t. Nothing when there is none with t >= 0, nearly.
std::optional<double> margin_of(const Instant& instant, const Eigen::Matrix3Xd& finger_forces_O,
                                double tolerance);

/// What was found out about an instant.
struct Verdict {
  Instant instant;
  double stability = 0;  // the least at the ends of the environment's friction
  double compliant_stability = 0;
  bool is_bounded = false;  // Problem (5)
  mechanics::FrictionVerdict over_friction;
};

}  // namespace graspless::fingertip::checking
