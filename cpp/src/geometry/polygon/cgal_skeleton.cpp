// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Uses CGAL's straight skeleton, licensed under GPL-3-or-later, and so is every binary that
// contains this file.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/create_offset_polygons_2.h>

#include "geometry/polygon/cgal_polygon.hpp"

namespace graspless::geometry {

std::vector<Eigen::Matrix2Xd> contract(const Eigen::Matrix2Xd& vertices, double width) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Polygon_2<Kernel> polygon;
  for (const auto& p : vertices.colwise()) polygon.push_back({p.x(), p.y()});
  std::vector<Eigen::Matrix2Xd> out;
  for (const auto& piece : CGAL::create_interior_skeleton_and_offset_polygons_2(width, polygon)) {
    Eigen::Matrix2Xd v(2, static_cast<Eigen::Index>(piece->size()));
    for (std::size_t i = 0; i < piece->size(); ++i) {
      v.col(static_cast<Eigen::Index>(i)) << (*piece)[i].x(), (*piece)[i].y();
    }
    out.push_back(v);
  }
  return out;
}

}  // namespace graspless::geometry
