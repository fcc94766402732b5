// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Geometry>

#include "graspless/export.hpp"

namespace graspless::geometry {

/// True if a pose is a rotation, within 1e-6, and a translation of at most kMaxLength along each
/// axis; both finite. Cheap enough for every pose that a search tries.
GRASPLESS_API bool is_pose(const Eigen::Isometry3d& X);

/// Throws std::invalid_argument that names `field` unless is_pose(X).
GRASPLESS_API void require_pose(const Eigen::Isometry3d& X, const std::string& field);

}  // namespace graspless::geometry
