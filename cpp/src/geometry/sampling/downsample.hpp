// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::geometry {

/// Columns of about `count` points (within a few percent where the cloud allows it), one a cell.
std::vector<int> downsample_to(const Eigen::Matrix3Xd& points, int count);

}  // namespace graspless::geometry
