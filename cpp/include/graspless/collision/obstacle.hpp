// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::collision {

/// Something that stands in the way.
struct Obstacle {
  std::string name;
  std::vector<geometry::PlacedShape> shapes;  ///< in its frame B
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
};

/// Throws std::invalid_argument that names the obstacle and the field: a name that is `taken`
/// already (`takers` says by whom) or given twice, no shape or a bad one, a pose that is not rigid.
GRASPLESS_API void require_obstacles(const std::vector<Obstacle>& obstacles,
                                     std::set<std::string> taken = {},
                                     const std::string& takers = "another obstacle");

}  // namespace graspless::collision
