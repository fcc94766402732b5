// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Edge lengths d at which the loops of classes are sought in K_d.
#pragma once

#include <vector>

#include "geometry/loops/classes.hpp"

namespace graspless::geometry {

using Judged = std::vector<JudgedClass>;

/// The classes of holes that are believed.
Judged holes_of(const Judged& classes);

/// True if a class lives in K_d.
bool is_alive(const JudgedClass& judged, double d);

/// True if the loop of a class is at its own scale in K_d.
bool accepts(const JudgedClass& judged, double d);

/// The lowest d at which exactly the holes live, and gaps and insides of handles do not: K_d is the
/// object without its hollows. 0 if there is none that is clear of other classes.
double clear_edge_length(const Filtration& filtration, const Judged& holes);

/// d at which most of the holes are at their own scale. If there is none, of the other classes.
double common_edge_length(const Filtration& filtration, const Judged& holes, const Judged& classes);

}  // namespace graspless::geometry
