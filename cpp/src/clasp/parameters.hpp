// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/clasp/clasp.hpp"

/// Parameters derived from hand and object where the options leave them open. The paper names this
/// as future work (Stork 2013, Section VI).
namespace graspless::clasp {

/// Corners of a loop of the object, 3 x n in O [m]. Throws std::invalid_argument if there is no
/// loop of that index.
const Eigen::Matrix3Xd& loop_points(const Problem& problem, int loop);

/// Smallest virtual linking of the finger curves after closing around a bar of `thickness` [m]. The
/// bar lies along `sideways` through the centre of the hand.
double reachable_linking(const robot::Robot& robot, const Hand& hand, double thickness);

/// Same for the open hand, with the loop just inside.
double open_linking(const robot::Robot& robot, const Hand& hand);

/// True if closing around such a bar does not increase the virtual linking over the open hand.
bool is_too_thick(const robot::Robot& robot, const Hand& hand, double thickness);

/// Half the width of the open hand along `sideways` [m].
double half_width(const robot::Robot& robot, const Hand& hand);

/// Half the width of a finger's tip in its narrowest direction [m]; 0 if it has no shape.
double tip_radius(const robot::Robot& robot, const Finger& finger);

/// Radius of the fingers about their curves: half the width of the thickest fingertip [m].
double finger_radius(const robot::Robot& robot, const Hand& hand);

/// Returns the options with every 0 replaced by its value for one loop.
Options derived(const Options& options, const Problem& problem, int loop);

}  // namespace graspless::clasp
