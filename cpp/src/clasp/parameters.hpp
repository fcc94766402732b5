// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/clasp/clasp.hpp"

/// What the options leave open, derived from hand and object (the paper's future work).
namespace graspless::clasp {

/// Virtual linking that `hand` reaches, the least over its curves, when it closes in the air around
/// a bar of this thickness [m] that lies along sideways in its middle.
double reachable_linking(const robot::Robot& robot, const Hand& hand, double thickness);

/// The same at the open state: how far the hand is closed when the loop has just slipped in.
double open_linking(const robot::Robot& robot, const Hand& hand);

/// Whether it closes no farther around such a bar than it is closed while open.
bool is_too_thick(const robot::Robot& robot, const Hand& hand, double thickness);

/// Half of what the fingers take up along sideways, at the open state [m].
double half_width(const robot::Robot& robot, const Hand& hand);

/// How thick the fingers are about their curves: half the width of the thickest tip [m].
double finger_radius(const robot::Robot& robot, const Hand& hand);

/// The options with every zero replaced, for one loop.
Options derived(const Options& options, const Problem& problem, int loop);

}  // namespace graspless::clasp
