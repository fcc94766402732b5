// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/collision/world.hpp"

namespace graspless::collision {

/// Length of the shortest translation that parts a touching pair of bodies at their poses [m]. It
/// is searched along 26 directions of W, so it is an upper bound, at most 15 % too long for convex
/// bodies. 0 if the pair is not tested or does not touch, infinity if no translation up to 4 m
/// parts it. For messages: takes up to some hundred tests of the pair.
GRASPLESS_API double overlap(World& world, int a, int b);

}  // namespace graspless::collision
