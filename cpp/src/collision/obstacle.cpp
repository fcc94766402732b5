// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/obstacle.hpp"

#include <sstream>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"

namespace graspless::collision {
namespace {

void require_padding(const Obstacle& obstacle, const std::string& field) {
  if (!(obstacle.padding >= 0 && obstacle.padding <= geometry::kMaxPadding)) {
    std::ostringstream fault;
    fault << field << ".padding must be in [0, " << geometry::kMaxPadding << "] m, not "
          << obstacle.padding;
    throw std::invalid_argument(fault.str());
  }
  if (obstacle.padding == 0) return;
  for (const auto& placed : obstacle.shapes) {
    const auto* mesh = std::get_if<geometry::Mesh>(&placed.shape);
    if (!mesh || mesh->triangles.cols() <= geometry::kMaxPaddedTriangles) continue;
    throw std::invalid_argument(field + ".padding: a mesh with a padding must have at most " +
                                std::to_string(geometry::kMaxPaddedTriangles) + " triangles, not " +
                                std::to_string(mesh->triangles.cols()) +
                                "; simplify it, or give boxes or hulls");
  }
}

}  // namespace

std::vector<geometry::PlacedShape> Obstacle::grown() const {
  return padding > 0 ? geometry::grown(shapes, padding) : shapes;
}

std::string Obstacle::label() const {
  if (padding == 0) return name;
  std::ostringstream text;
  text << name << " (padding " << padding * 1e3 << " mm)";
  return text.str();
}

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
    require_padding(obstacle, field);
  }
}

}  // namespace graspless::collision
