// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Slides that go on from where they were interrupted: the finger presses on the object, and the
// object is not where the plan had it.
#pragma once

#include "graspless/slide/slide.hpp"

namespace graspless::slide {

/// Tolerances of an interruption.
constexpr double kFlatHeight = 0.02;     ///< of the object above or below the support [m]
constexpr double kFlatTilt = 0.175;      ///< of the object against the support, 10 degrees [rad]
constexpr double kTouchHeight = 0.002;   ///< of the commanded tip above the object's top face [m]
constexpr double kMaxCorrection = 0.05;  ///< Robot::step() from q to the plan's first row [rad]

/// Throws std::invalid_argument that names the field: q of the wrong size or not finite, X_WO or
/// X_WO_goal not a rigid pose.
GRASPLESS_API void validate(const Problem& problem, const Interruption& at);

/// Plans the rest of a slide, without lifting the finger: slide, lift, reach, grasp and close. The
/// problem's own X_WO_start and q_home do not count; goals, options and budget are those of plan().
///
/// The object is taken to lie flat on the support, with yaw and centre of mass as measured. The
/// plan begins at the configuration nearest to q that presses, and the object follows the fingertip
/// there.
///
/// A state from which no slide can go on is a status: off_support (the object is kFlatHeight or
/// kFlatTilt off the plane), contact_lost (the fingertip is above the object, beside it, where its
/// heights are not level, or within options.rim_margin of its outline or options.tip_margin of the
/// support's edge; or q is kMaxCorrection away from all configurations that press), or
/// start_in_collision.
GRASPLESS_API Plan resume(const Problem& problem, const Interruption& at,
                          const Options& options = {}, const planning::Budget& budget = {});

/// Plans a slide anew from the state in which one was interrupted: retreat, approach, press, slide,
/// lift, reach, grasp and close. For a contact that was lost, or from which no way leads to a goal.
///
/// The segment `retreat` lifts the finger off, along the line on which the contact stands still if
/// it presses on the object, straight up otherwise. Statuses are those of plan(), and: off_support
/// (as in resume(), or the centre of mass is beyond the support's edge, so that the object would
/// fall without the finger), contact_lost (the hand is not open, or the fingertip is deeper than
/// its band) and start_in_collision (the finger cannot be lifted off).
GRASPLESS_API Plan restart(const Problem& problem, const Interruption& at,
                           const Options& options = {}, const planning::Budget& budget = {});

}  // namespace graspless::slide
