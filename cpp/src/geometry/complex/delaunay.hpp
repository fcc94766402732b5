// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

/// CGAL's 3-D Delaunay triangulation with plain arrays as interface. Its heavy headers are compiled
/// once.
namespace graspless::geometry {

struct Delaunay {
  /// A triangle and the two regions of space that it separates. A region is a tetrahedron, or 0 for
  /// the outside of the hull.
  struct Facet {
    std::array<int, 3> vertices;  // ascending
    std::array<int, 2> regions;
  };
  int dimension = 0;  ///< of the affine hull of the points; below 3 there are no facets
  int num_vertices = 0;
  int num_regions = 0;
  std::vector<Facet> facets;
};

/// Triangulates finite points (3 x n). The first of equal points becomes the vertex. Points are
/// perturbed by up to 1e-9 of their extent, for speed, so planar points may seem to span a volume.
Delaunay delaunay(const Eigen::Matrix3Xd& points);

}  // namespace graspless::geometry
