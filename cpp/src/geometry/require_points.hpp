// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Core>

namespace graspless::geometry {

/// Throws std::invalid_argument that names `what` and the point unless every coordinate is finite
/// and within kMaxLength.
void require_points(const Eigen::Matrix3Xd& points, const std::string& what);

}  // namespace graspless::geometry
