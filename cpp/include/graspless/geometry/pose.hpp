// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Geometry>

#include "graspless/export.hpp"

namespace graspless::geometry {

/// Throws std::invalid_argument that names `field` unless a pose is rigid, finite and within
/// kMaxLength of the origin.
GRASPLESS_API void require_pose(const Eigen::Isometry3d& X, const std::string& field);

}  // namespace graspless::geometry
