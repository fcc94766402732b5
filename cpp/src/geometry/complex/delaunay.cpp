// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/complex/delaunay.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include "graspless/watch.hpp"

#include "geometry/pulse.hpp"

namespace graspless::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;  // column of the point
using Cell =
    CGAL::Triangulation_cell_base_with_info_3<int, Kernel,  // region
                                              CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Triangulation =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

/// Perturbation relative to the cloud's extent. Four coplanar or five cospherical points need exact
/// arithmetic in CGAL. Clouds of flat walls contain many of them, and the perturbation makes them
/// three times as fast. Where it changes the triangulation, the triangulation was not unique.
constexpr double kShift = 1e-9;

/// Hash of the coordinates in [-0.5, 0.5). Equal points stay equal, and order does not matter.
double shift(const Eigen::Vector3d& p, std::uint64_t axis) {
  std::uint64_t hash = axis;
  for (const double value : p) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ull;
    hash ^= hash >> 29;
  }
  return static_cast<double>(hash >> 11) / 9007199254740992.0 - 0.5;
}

std::vector<Point> perturbed(const Eigen::Matrix3Xd& points) {
  std::vector<Point> result;
  result.reserve(points.cols());
  const double scale =
      kShift * (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
  for (const auto& column : points.colwise()) {
    const Eigen::Vector3d p =
        column.array() + 0.0;  // negative zeros become positive: they must have the same hash
    result.emplace_back(p.x() + scale * shift(p, 1), p.y() + scale * shift(p, 2),
                        p.z() + scale * shift(p, 3));
  }
  return result;
}

Triangulation triangulate(const std::vector<Point>& points) {
  using Map = CGAL::Pointer_property_map<Point>::const_type;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  CGAL::spatial_sort(
      order.begin(), order.end(),
      CGAL::Spatial_sort_traits_adapter_3<Kernel, Map>(CGAL::make_property_map(points)));

  Triangulation result;
  Triangulation::Cell_handle hint;
  for (const std::size_t i : order) {
    poll();
    const auto before = result.number_of_vertices();
    const auto vertex = result.insert(points[i], hint);
    const bool is_new = result.number_of_vertices() > before;
    vertex->info() = is_new ? static_cast<int>(i) : std::min(vertex->info(), static_cast<int>(i));
    hint = vertex->cell();
  }
  return result;
}

int number_regions(Triangulation& triangulation) {
  int next = 1;
  Pulse pulse;
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell) {
    pulse();
    cell->info() = triangulation.is_infinite(cell) ? 0 : next++;
  }
  return next;
}

}  // namespace

Delaunay delaunay(const Eigen::Matrix3Xd& points) {
  if (points.cols() == 0) return {};  // CGAL's map takes the address of the first point
  Triangulation triangulation = triangulate(perturbed(points));

  Delaunay result;
  result.dimension = triangulation.dimension();
  result.num_vertices = static_cast<int>(triangulation.number_of_vertices());
  if (result.dimension < 3) return result;
  result.num_regions = number_regions(triangulation);
  result.facets.reserve(triangulation.tds().number_of_cells() * 2);
  Pulse pulse;
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell) {
    pulse();
    if (cell->info() == 0) continue;
    for (int i = 0; i < 4; ++i) {
      const int beyond = cell->neighbor(i)->info();
      if (beyond > cell->info()) continue;  // listed from the other side
      std::array<int, 3> v{};
      for (int k = 0; k < 3; ++k) {
        v[k] = cell->vertex((i + 1 + k) & 3)->info();
      }
      if (v[0] > v[1]) std::swap(v[0], v[1]);
      if (v[1] > v[2]) std::swap(v[1], v[2]);
      if (v[0] > v[1]) std::swap(v[0], v[1]);
      result.facets.push_back({v, {cell->info(), beyond}});
    }
  }
  return result;
}

}  // namespace graspless::geometry
