// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace graspless::geometry {

/// Sorts points (3 x n) along a Hilbert curve (CGAL), so that neighbours in space are close in
/// memory.
Eigen::Matrix3Xd in_hilbert_order(const Eigen::Matrix3Xd& points);

}  // namespace graspless::geometry
