// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::geometry {

/// Downsamples a cloud (3 x n) to about `count` points, within a few percent if possible. Returns
/// the indices kept, ascending.
std::vector<int> downsample_to(const Eigen::Matrix3Xd& points, int count);

}  // namespace graspless::geometry
