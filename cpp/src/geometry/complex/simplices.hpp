// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "geometry/complex/delaunay.hpp"

namespace graspless::geometry {

/// The edges and triangles of a Delaunay triangulation, both in lexicographic order of their
/// vertices.
struct Simplices {
  struct Triangle {
    std::array<int, 3> vertices;  // a < b < c
    std::array<int, 3> edges;     // ab, ac, bc
    std::array<int, 2> regions;
    double longest_edge;
  };
  int num_vertices = 0;  ///< distinct points
  int num_regions = 0;
  std::vector<std::array<int, 2>> edges;  ///< the smaller vertex first
  std::vector<int> first_edge;            ///< by its smaller vertex; one more for the end
  std::vector<double> lengths;            ///< of the edges
  std::vector<Triangle> triangles;

  /// The index of an edge; -1 when there is none.
  int edge(int a, int b) const;
};

Simplices simplices(const Eigen::Matrix3Xd& points, const Delaunay& delaunay);

}  // namespace graspless::geometry
