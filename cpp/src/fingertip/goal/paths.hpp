// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fingertip/goal/contact_states.hpp"

namespace graspless::fingertip {

/// The object's paths from start to goal that tumble over these edges, with slides and turns
/// before, between and after them where the object stands by itself.
///
/// Motions on the floor act on a pose from the left and tumbles from the right, so they commute:
/// whatever the order, all slides and turns together make the same motion of the floor,
/// X_WO_goal (X_WO_start tumbles)^-1, one turn and one slide. The paths differ in when each comes:
/// every pair of times, either order at one time, and both at once as a turn about the pole of the
/// motion.
std::vector<Path> goal_paths(const Problem& problem, const Goal& goal, const ContactStates& states,
                             int start_face, const TumbleSequence& tumbles);

/// The tumbles one after the other, without slides and turns.
Path tumbles_alone(const Goal& goal, const TumbleSequence& tumbles);

}  // namespace graspless::fingertip
