// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses along a screw: the object's motion between two poses of a plan.
#pragma once

#include <Eigen/Geometry>

namespace graspless::fingertip {

/// The pose at `s` in [0, 1] of the motion of constant twist from X_WA to X_WB, by less than half a
/// turn.
Eigen::Isometry3d along_screw(const Eigen::Isometry3d& X_WA, const Eigen::Isometry3d& X_WB,
                              double s);

}  // namespace graspless::fingertip
