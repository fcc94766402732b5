// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clasp/query.hpp"

namespace graspless::clasp {

/// Continues the reach of a hand of two fingers: the handle then runs square through the plane of
/// the fingers, half way between their pads. Returns false, and leaves the reach, if the arm cannot
/// do that or something is in the way.
bool square_up(Query& query, const geometry::ClaspTarget& target_W, planning::Path& reach);

/// Closes the hand at the end of a reach. If a hand of two fingers stops with one of them away from
/// the object, the reach is continued towards that side and the hand closes there. Fingers that
/// mimic each other could not pinch otherwise.
void close_centered(Query& query, planning::Path& reach, planning::Path& close);

}  // namespace graspless::clasp
