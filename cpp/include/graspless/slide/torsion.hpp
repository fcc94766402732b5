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
///
/// Before that, the pad must hold the object at all. The support's pull goes through the centre of
/// pressure, by e beside the pad's middle: it takes
///   mu_s (N + m g) / (mu_p N) sqrt(1 + (e / w)^2)
/// of what the pad can hold, and the pull on the tip changes N.
namespace graspless::slide {

/// Normal force of a flexed finger whose tip is commanded `depth` below the top face [N].
GRASPLESS_API double press_force(const Hand& hand, double depth, double pitch);

/// The same while the support's `friction` pulls at the tip, of the press and of an object's
/// `weight` [N]. `along` is the cosine between the finger's heading and its way: an object that it
/// drags behind itself (-1) takes from the press, one that it pushes (1) adds to it. Infinite where
/// the finger jams.
GRASPLESS_API double dragging_force(const Hand& hand, double depth, double pitch, double along,
                                    double friction, double weight);

/// The largest k [rad/m] for a mean radius r [m] of the support's friction and a press of N [N];
/// infinite where the pad could turn the object on the spot, 0 where it slips off it anyway.
GRASPLESS_API double max_turn_per_length(const Problem& problem, double radius, double press);

/// The greatest share of what the pad can hold that the drag of the plan's slide takes: above 1 the
/// pad loses the object, or the object turns under it. 0 where there is no slide or no known press.
GRASPLESS_API double drag_load(const Problem& problem, const Plan& plan);

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
