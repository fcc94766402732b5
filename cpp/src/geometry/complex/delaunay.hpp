// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

/// CGAL's 3-D Delaunay triangulation on plain arrays, so that its headers are compiled once.
namespace graspless::geometry {

struct Delaunay {
  /// A triangle and the two regions of space that it parts: a tetrahedron each, or 0, what lies
  /// outside the hull.
  struct Facet {
    std::array<int, 3> vertices;  // ascending
    std::array<int, 2> regions;
  };
  int dimension = 0;  ///< of the points' span; less than 3: no facets
  int num_vertices = 0;
  int num_regions = 0;
  std::vector<Facet> facets;
};

/// Of equal points the first counts. Points must be finite. They are moved by up to 1e-9 of their
/// extent (see the source); planar points may therefore seem to span a volume.
Delaunay delaunay(const Eigen::Matrix3Xd& points);

}  // namespace graspless::geometry
