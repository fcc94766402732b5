// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/polygon.hpp"
#include "graspless/geometry/shape.hpp"
#include "graspless/watch.hpp"

namespace graspless::slide {

/// Convex prisms that fill the slab between two heights over a polygon.
inline std::vector<geometry::PlacedShape> prisms(const geometry::Polygon& polygon, double bottom,
                                                 double top) {
  std::vector<geometry::PlacedShape> shapes;
  for (const geometry::Polygon& part : polygon.convex_parts()) {
    poll();
    Eigen::Matrix3Xd vertices(3, 2 * part.size());
    vertices.topRows<2>() << part.vertices(), part.vertices();
    vertices.row(2) << Eigen::RowVectorXd::Constant(part.size(), bottom),
        Eigen::RowVectorXd::Constant(part.size(), top);
    shapes.push_back({geometry::Convex{vertices}, Eigen::Isometry3d::Identity()});
  }
  return shapes;
}

}  // namespace graspless::slide
