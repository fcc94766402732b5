// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/slide/slide.hpp"

/// Whether the fingertip's pad can turn the object that it slides: Eq. (2) says that it always
/// does.
///
/// The support holds the object back with mu_s (N + m g), at a mean radius r about the centre of
/// pressure; the pad takes it along with mu_p N, on a line whose mean radius is w (a quarter of its
/// width). With ellipsoidal limit surfaces (Howe, Cutkosky 1996), R = (mu_s (N + m g) / (mu_p N))^2
/// and a turn of k per length of way, the object keeps up where
///   R (1 + (r / w)^2 r^2 k^2) <= 1 + r^2 k^2.
namespace graspless::slide {

/// Normal force of a flexed finger whose tip is commanded `depth` below the top face [N].
GRASPLESS_API double press_force(const Hand& hand, double depth, double pitch);

/// The largest k [rad/m] for a mean radius r [m] of the support's friction and a press of N [N];
/// infinite where the pad could turn the object on the spot, 0 where it slips off it anyway.
GRASPLESS_API double max_turn_per_length(const Problem& problem, double radius, double press);

/// How fast the slide of a plan turns.
struct Turning {
  double most = 0;     ///< greatest turn per length of way [rad/m]
  double allowed = 0;  ///< least k on the way [rad/m]
  double lag = 0;      ///< the angle by which the object may stay behind in all [rad]
};

/// Of the plan's slide; where there is none, or the hand's finger does not flex and so has no known
/// press, everything is allowed.
GRASPLESS_API Turning turning(const Problem& problem, const Plan& plan);

}  // namespace graspless::slide
