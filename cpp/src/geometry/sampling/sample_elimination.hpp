// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::geometry {

/// `count` of the points, spread as evenly as may be: the point that stands closest among the
/// others is taken away until count are left (Yuksel 2015). `area` [m^2] is what the points cover.
/// Columns kept, ascending.
std::vector<int> eliminate_samples(const Eigen::Matrix3Xd& points, int count, double area);

}  // namespace graspless::geometry
