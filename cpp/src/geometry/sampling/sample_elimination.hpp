// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::geometry {

/// Selects `count` points that are spread evenly: removes the most crowded point until `count` are
/// left (Yuksel 2015). `points`: 3 x n [m], spread over a surface of `area` [m^2]. Returns the
/// indices kept, ascending.
std::vector<int> eliminate_samples(const Eigen::Matrix3Xd& points, int count, double area);

}  // namespace graspless::geometry
