// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/obstacle.hpp"

#include <stdexcept>

#include "graspless/geometry/pose.hpp"

namespace graspless::collision {

void require_obstacles(const std::vector<Obstacle>& obstacles, std::set<std::string> taken,
                       const std::string& takers) {
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const Obstacle& obstacle = obstacles[i];
    const std::string field = "obstacles[" + std::to_string(i) + "]";
    if (!taken.insert(obstacle.name).second) {
      throw std::invalid_argument(field + ".name '" + obstacle.name + "' is taken by " + takers);
    }
    if (obstacle.shapes.empty()) throw std::invalid_argument(field + ".shapes must not be empty");
    for (const auto& placed : obstacle.shapes) {
      geometry::validate(placed.shape, field);
      geometry::require_pose(placed.X_BG, field + ".shapes.X_BG");
    }
    geometry::require_pose(obstacle.X_WB, field + ".X_WB");
  }
}

}  // namespace graspless::collision
