// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "graspless/mechanics/contact.hpp"
#include "graspless/mechanics/contact_patch.hpp"

namespace graspless::fingertip {

constexpr double kMaxTurn = 3.0;  // of one arc [rad]: half a turn leaves the way open

/// The body twist (in O) that carries X_WO to X_WO_next in unit time along a screw: X_WO exp(t).
mechanics::Vector6d screw_between(const Eigen::Isometry3d& X_WO,
                                  const Eigen::Isometry3d& X_WO_next);

/// X_WO exp(part * twist_O).
Eigen::Isometry3d along_screw(const Eigen::Isometry3d& X_WO, const mechanics::Vector6d& twist_O,
                              double part);

/// An object at this pose that moves with a body twist.
mechanics::BodyState moving_state(const Eigen::Isometry3d& X_WO,
                                  const mechanics::Vector6d& twist_O);
/// The same at rest; the twist only turns the cones.
mechanics::BodyState resting_state(const Eigen::Isometry3d& X_WO,
                                   const mechanics::Vector6d& twist_O);

}  // namespace graspless::fingertip
