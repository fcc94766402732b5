// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace graspless::geometry {

/// Returns the smallest rotation that turns the z axis onto a direction of any length. Eigen's own
/// function is a singular value decomposition, which takes seconds to compile wherever it is used.
Eigen::Quaterniond turn_from_z(const Eigen::Vector3d& direction);

}  // namespace graspless::geometry
