// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/cgal_polygon.hpp"

#include <iterator>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/partition_2.h>

namespace graspless::geometry {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Partition_traits_2<Epick>;

template <typename CgalPolygon>
CgalPolygon to_cgal(const Eigen::Matrix2Xd& vertices) {
  CgalPolygon polygon;
  for (const auto& p : vertices.colwise()) polygon.push_back(Epick::Point_2(p.x(), p.y()));
  return polygon;
}

template <typename CgalPolygon>
Eigen::Matrix2Xd from_cgal(const CgalPolygon& polygon) {
  Eigen::Matrix2Xd vertices(2, static_cast<Eigen::Index>(polygon.size()));
  Eigen::Index i = 0;
  for (auto p = polygon.vertices_begin(); p != polygon.vertices_end(); ++p) {
    vertices.col(i++) << p->x(), p->y();
  }
  return vertices;
}

}  // namespace

bool is_simple(const Eigen::Matrix2Xd& vertices) {
  return to_cgal<CGAL::Polygon_2<Epick>>(vertices).is_simple();
}

std::vector<Eigen::Matrix2Xd> convex_partition(const Eigen::Matrix2Xd& vertices) {
  const auto polygon = to_cgal<Traits::Polygon_2>(vertices);
  std::vector<Traits::Polygon_2> parts;
  CGAL::approx_convex_partition_2(polygon.vertices_begin(), polygon.vertices_end(),
                                  std::back_inserter(parts), Traits());
  std::vector<Eigen::Matrix2Xd> out;
  for (const auto& part : parts) out.push_back(from_cgal(part));
  return out;
}

}  // namespace graspless::geometry
