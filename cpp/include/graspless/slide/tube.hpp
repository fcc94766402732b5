// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the object can be during a slide. Eq. (2) lets it move with the fingertip. Here its motion
// is integrated under the friction of pad and support (ellipsoidal limit surfaces, Howe and
// Cutkosky 1996; Lynch, Maekawa and Tanie 1992), for several worlds: that of the task, and those in
// which the pad is as weak, and the centre of mass as far aside, as in the worst 1 % of the worlds
// that the spreads of the options allow. The tube is the union of their paths, widened by the
// errors that have nothing to do with slip: start pose, flexure, thickness, height of the support,
// and the arm.
#pragma once

#include <vector>

#include "graspless/export.hpp"
#include "graspless/slide/options.hpp"
#include "graspless/slide/problem.hpp"

namespace graspless::slide {

struct Plan;

/// Bounds on where the object can be, relative to the plan. One value for each row of the slide.
struct Tube {
  std::vector<double> position;  ///< distance of the object's origin from its planned position [m]
  std::vector<double> angle;     ///< angle from its planned orientation [rad]
};

/// Returns the tube of the plan's slide; empty if it has none.
GRASPLESS_API Tube tube(const Problem& problem, const Plan& plan, const Options& options = {});

/// Returns mu_s (N + m g) / (mu_p N), the least share of the pad's friction that a straight slide
/// can take, in the worst 1 % of the worlds. The finger presses as deep as the options allow, and
/// pushes the object ahead. From 1 on, the object stays where it is.
GRASPLESS_API double least_drag(const Problem& problem, const Options& options = {});

}  // namespace graspless::slide
