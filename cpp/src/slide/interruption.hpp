// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "slide/motions.hpp"
#include "slide/query.hpp"

namespace graspless::slide {

/// Returns the configuration of the arm nearest to at.q that presses on the object, and makes the
/// object's pose there the start of the query. Returns nothing, with the plan's status and reason,
/// if no slide can begin there.
std::optional<Eigen::VectorXd> find_pressed_start(Query& query, const Interruption& at, Plan& plan);

/// Motion of the arm off the object, from where a slide was interrupted.
struct Retreat {
  planning::Path path;
  Planar object_S;  ///< the measured object, laid flat
};

/// Returns the motion that lifts the finger off, so that the slide can be planned anew. Returns
/// nothing, with the plan's status and reason, if there is none or the object would fall.
std::optional<Retreat> find_retreat(Query& query, const Interruption& at, Plan& plan);

}  // namespace graspless::slide
