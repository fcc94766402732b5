// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace graspless::geometry {

/// The same points along a Hilbert curve (CGAL): neighbours in space are near in memory.
Eigen::Matrix3Xd in_hilbert_order(const Eigen::Matrix3Xd& points);

}  // namespace graspless::geometry
