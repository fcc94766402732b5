// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Friction limits of a slide. Eq. (2) assumes that the object always moves and turns with the
// fingertip; these functions say how far the friction of the fingertip's pad allows that.
//
// The support's friction resists with the force mu_s (N + m g), at a mean radius r about the
// centre of pressure. The pad drags the object with at most mu_p N, on a line contact of mean
// radius w (a quarter of the pad's width). Let R = (mu_s (N + m g) / (mu_p N))^2, and let the
// slide turn by k per distance [rad/m]. With ellipsoidal limit surfaces (Howe, Cutkosky 1996) the
// object turns with the pad if
//   R (1 + (r / w)^2 r^2 k^2) <= 1 + r^2 k^2.
//
// The pad must also be able to drag the object in a straight line. The support's friction acts at
// the centre of pressure, at a distance e beside the middle of the pad. It uses the share
//   mu_s (N + m g) / (mu_p N) sqrt(1 + (e / w)^2)
// of the pad's friction limit. The drag on the tip also changes the normal force N.
//
// An arm under impedance control of stiffness K gives way to the same friction: finger and object
// trail behind the commanded tip by s = mu_s (N + m g) / K, against the direction of motion. While
// the finger lifts, N falls and the spring pulls the object after it, as long as the pad grips:
// K s = mu_s (N + m g) <= mu_p N. It slips at N = mu_s m g / (mu_p - mu_s), where
//   s = mu_s mu_p m g / ((mu_p - mu_s) K)
// is left for good.
#pragma once

#include "graspless/slide/slide.hpp"

namespace graspless::slide {

/// Returns the normal force [N] of a finger whose tip is commanded `depth` [m] below the top face
/// at `pitch` [rad]: that of its bent flexure, of the arm's impedance control, or hand.press_force.
GRASPLESS_API double press_force(const Hand& hand, double depth, double pitch);

/// Returns the normal force [N] while the object is dragged. The support's `friction` acts on the
/// sum of the press and the object's `weight` [N]. `along` is the cosine of the angle between the
/// finger's heading and the direction of motion: pulling the object (-1) reduces the press of a
/// flexing finger, pushing it (1) increases it. Infinite if the finger jams.
GRASPLESS_API double dragging_force(const Hand& hand, double depth, double pitch, double along,
                                    double friction, double weight);

/// Returns the largest turn per distance k [rad/m] that the pad can impose, for a mean radius r of
/// the support's friction [m] and a press N [N]. Infinite if the pad could turn the object on the
/// spot, 0 if it cannot even drag it.
GRASPLESS_API double max_turn_per_length(const Problem& problem, double radius, double press);

/// Returns the largest share of the pad's friction limit that the plan's slide uses. Above 1, the
/// pad slips or the object turns under it. 0 if there is no slide.
GRASPLESS_API double drag_load(const Problem& problem, const Plan& plan);

/// Distances by which the object trails behind the plan, because the wrist gives way.
struct Trailing {
  double sliding = 0;  ///< largest during the slide [m]
  double left = 0;     ///< after the finger has been lifted [m]
};

/// Returns the distances of the plan's slide; 0 for finger models other than impedance, and if
/// there is no slide.
GRASPLESS_API Trailing trailing(const Problem& problem, const Plan& plan);

/// Turn rates of a plan's slide, per distance that the object moves.
struct Turning {
  double max_turn_rate = 0;      ///< largest turn rate of the slide [rad/m]
  double allowed_turn_rate = 0;  ///< turn rate that the pad can impose everywhere [rad/m]
  double lag = 0;                ///< angle by which the object may lag behind in total [rad]
};

/// Returns the turn rates of the plan's slide. If there is no slide, the allowed rate is infinite.
GRASPLESS_API Turning turning(const Problem& problem, const Plan& plan);

}  // namespace graspless::slide
