// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Words for a search that found nothing: the most frequent rejections, and for a collision the
// depth and the pose of its first occurrence. The lengths are measured here, not in the search.
#pragma once

#include "slide/query.hpp"

namespace graspless::slide {

/// Returns a length in millimetres with two digits or more, such as "14 mm".
std::string in_mm(double length);
/// "5 mm outside the edge", of a point that is `inside` the edge [m].
std::string beside_edge(double inside);

/// True if the robot at q_home can open its hand without collision. Otherwise sets the plan's
/// status and reason.
bool is_home_free(Query& query, Plan& plan);

/// True unless all of the object is farther from the arm's first joint than the fingertip can get.
/// Otherwise sets the plan's status and reason. Arms with sliding joints are not judged.
bool can_reach(const Query& query, Plan& plan);

/// True if the object has a level part on which the finger may press. Otherwise sets the plan's
/// status and reason.
bool can_press(const Query& query, Plan& plan);

/// True if the pad can drag the object somewhere. Otherwise sets the plan's status and reason.
bool can_drag(const Query& query, Plan& plan);

/// True if the object stays where it is to be left, if there is such a place. Otherwise sets the
/// plan's status and reason.
bool can_be_left(const Query& query, Plan& plan);

/// Describes the plan's status in one sentence, from its statistics.
std::string reason(Query& query, const Plan& plan);

}  // namespace graspless::slide
