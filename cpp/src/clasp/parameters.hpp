// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/clasp/clasp.hpp"

/// What the options leave open, derived from hand and object (the paper's future work).
namespace graspless::clasp {

/// Virtual linking that `hand` reaches, the least over its curves, when it closes in the air around
/// a bar of this thickness [m] that lies along sideways in its middle.
double reachable_linking(const robot::Robot& robot, const Hand& hand, double thickness);

/// The options with every zero replaced, for one loop.
Options derived(const Options& options, const Problem& problem, int loop);

/// Half the extent of the hand's curves along sideways, at the open state [m].
double half_width(const robot::Robot& robot, const Hand& hand);

}  // namespace graspless::clasp
