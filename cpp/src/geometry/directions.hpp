// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace graspless::geometry {

/// Direction i of n, which are spread evenly over the sphere (Fibonacci spiral).
inline Eigen::Vector3d spread_direction(int i, int n) {
  constexpr double kGolden = 2.39996322972865332;  // angle [rad]
  const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z);
  return {r * std::cos(kGolden * i), r * std::sin(kGolden * i), z};
}

}  // namespace graspless::geometry
