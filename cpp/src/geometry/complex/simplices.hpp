// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "geometry/complex/delaunay.hpp"

namespace graspless::geometry {

/// Edges and triangles of a Delaunay triangulation, in lexicographic order of their vertices.
struct Simplices {
  struct Triangle {
    std::array<int, 3> vertices;  // a < b < c
    std::array<int, 3> edges;     // ab, ac, bc
    std::array<int, 2> regions;   // as in Delaunay::Facet
    double longest_edge;          // [m]
  };
  int num_vertices = 0;  ///< distinct points
  int num_regions = 0;
  std::vector<std::array<int, 2>> edges;  ///< the smaller vertex first
  std::vector<int> first_edge;  ///< first edge of each smaller vertex, and the number of edges
  std::vector<double> lengths;  ///< of the edges [m]
  std::vector<Triangle> triangles;

  /// Index of the edge between two vertices, or -1.
  int edge(int a, int b) const;
};

Simplices simplices(const Eigen::Matrix3Xd& points, const Delaunay& delaunay);

}  // namespace graspless::geometry
