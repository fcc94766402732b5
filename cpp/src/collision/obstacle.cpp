// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/obstacle.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"

#include "collision/prepared.hpp"
#include "collision/recent.hpp"
#include "text.hpp"

namespace graspless::collision {
namespace {

/// Number of triangles of the meshes among some shapes.
Eigen::Index triangles_of(const std::vector<geometry::PlacedShape>& shapes) {
  Eigen::Index count = 0;
  for (const auto& placed : shapes) {
    if (const auto* mesh = std::get_if<geometry::Mesh>(&placed.shape))
      count += mesh->triangles.cols();
  }
  return count;
}

/// True if two shapes of one kind are the same.
struct Same {
  const geometry::Shape& other;
  bool operator()(const geometry::Box& a) const {
    return a.size == std::get<geometry::Box>(other).size;
  }
  bool operator()(const geometry::Sphere& a) const {
    return a.radius == std::get<geometry::Sphere>(other).radius;
  }
  bool operator()(const geometry::Capsule& a) const {
    const auto& b = std::get<geometry::Capsule>(other);
    return a.radius == b.radius && a.length == b.length;
  }
  bool operator()(const geometry::Convex& a) const {
    const auto& b = std::get<geometry::Convex>(other);
    return a.vertices.cols() == b.vertices.cols() && a.vertices == b.vertices;
  }
  bool operator()(const geometry::Mesh& a) const {
    return is_same(a, std::get<geometry::Mesh>(other));
  }
};

bool are_same(const geometry::PlacedShape& a, const geometry::PlacedShape& b) {
  return a.shape.index() == b.shape.index() && a.X_BG.matrix() == b.X_BG.matrix() &&
         std::visit(Same{b.shape}, a.shape);
}

bool grow_alike(const Obstacle& a, const Obstacle& b) {
  return a.padding == b.padding &&
         std::equal(a.shapes.begin(), a.shapes.end(), b.shapes.begin(), b.shapes.end(), are_same);
}

/// Triangles of all obstacles whose solids are kept: each has a hull, which takes 0.2 ms and 4 kB,
/// and planners and checks make worlds again and again.
constexpr Eigen::Index kMostKept = 4 * geometry::kMaxPaddedTriangles;

}  // namespace

void require_padding(const Obstacle& obstacle, const std::string& field) {
  require(obstacle.padding >= 0 && obstacle.padding <= geometry::kMaxPadding, field,
          obstacle.padding, "must be in [0, " + figure(geometry::kMaxPadding) + "] m");
  const Eigen::Index count = triangles_of(obstacle.shapes);
  if (obstacle.padding > 0 && count > geometry::kMaxPaddedTriangles) {
    throw std::invalid_argument(field + ": meshes with a padding must have at most " +
                                std::to_string(geometry::kMaxPaddedTriangles) + " triangles, not " +
                                std::to_string(count) + "; simplify them, or give boxes or hulls");
  }
}

Solid Obstacle::solid() const {
  const std::string what = "obstacle '" + name + "'";
  const Eigen::Index triangles = triangles_of(shapes);
  if (padding == 0 || triangles == 0) return Solid(grown(), what);
  // Never destroyed: a thread may still plan when others end.
  static auto& kept = *new Recent<Obstacle, Solid>(kMostKept);
  const auto is_it = [&](const Obstacle& other) { return grow_alike(other, *this); };
  if (std::optional<Solid> found = kept.find(is_it)) return *std::move(found);
  Solid made(grown(), what);
  kept.add(*this, made, triangles);
  return made;
}

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
    if (obstacle.padding > 0 && !taken.insert(obstacle.label()).second) {
      throw std::invalid_argument(field + ": its name in messages, '" + obstacle.label() +
                                  "', is taken by " + takers);
    }
    if (obstacle.shapes.empty()) throw std::invalid_argument(field + ".shapes must not be empty");
    for (const auto& placed : obstacle.shapes) {
      geometry::validate(placed.shape, field);
      geometry::require_pose(placed.X_BG, field + ".shapes.X_BG");
    }
    geometry::require_pose(obstacle.X_WB, field + ".X_WB");
    require_padding(obstacle, field + ".padding");
  }
}

}  // namespace graspless::collision
