// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/solid.hpp"

#include <algorithm>
#include <stdexcept>

#include "graspless/watch.hpp"

#include "collision/world_impl.hpp"

namespace graspless::collision {
namespace {

/// Returns an upper bound on the distance of the shape's points from the body's origin [m].
double shape_radius(const CollisionShape& shape) {
  double farthest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    farthest = std::max(farthest, (shape.X_BC * shape.core.half.cwiseProduct(sign)).norm());
  }
  return farthest + shape.core.radius;
}

}  // namespace

Solid::Solid(const std::vector<geometry::PlacedShape>& shapes, const std::string& what) {
  if (shapes.empty()) throw std::invalid_argument(what + " must have a shape");
  auto data = std::make_shared<Data>();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    poll();
    data->shapes.push_back(
        make_collision_shape(shapes[i], what + " shapes[" + std::to_string(i) + "]"));
    data->radius = std::max(data->radius, shape_radius(data->shapes.back()));
    data->has_enclosure |= data->shapes.back().enclosure != nullptr;
  }
  data_ = std::move(data);
}

}  // namespace graspless::collision
