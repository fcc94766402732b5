// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "graspless/geometry/shape.hpp"

/// Meshes for the fingertip planner's tests.
namespace graspless::fingertip {

/// A polygon in x and z (counter-clockwise seen from -y; star-shaped about its first vertex's fan),
/// drawn out from y = 0 to `depth`.
inline geometry::Mesh prism_mesh(const std::vector<Eigen::Vector2d>& outline, double depth) {
  const int n = static_cast<int>(outline.size());
  geometry::Mesh mesh{Eigen::Matrix3Xd(3, 2 * n), Eigen::Matrix3Xi(3, 4 * n - 4)};
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector2d& p = outline[i];
    mesh.vertices.col(i) << p.x(), 0, p.y();
    mesh.vertices.col(n + i) << p.x(), depth, p.y();
  }
  int t = 0;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.triangles.col(t++) << i, j, n + j;
    mesh.triangles.col(t++) << i, n + j, n + i;
  }
  for (int i = 1; i + 1 < n; ++i) {
    mesh.triangles.col(t++) << 0, i + 1, i;
    mesh.triangles.col(t++) << n, n + i, n + i + 1;
  }
  mesh.triangles.row(1).swap(mesh.triangles.row(2));
  return mesh;
}

/// An L of unit thickness: a bar of 3 along x, a cube on its end at x = 0, depth 1 along y.
inline geometry::Mesh l_mesh() {
  // Begins at the inner corner, from which the whole L is seen.
  return prism_mesh({{1, 1}, {1, 2}, {0, 2}, {0, 0}, {3, 0}, {3, 1}}, 1);
}

/// A sphere of radius 1 in rings and sectors.
inline geometry::Mesh sphere_mesh(int rings, int sectors) {
  geometry::Mesh mesh{Eigen::Matrix3Xd(3, (rings - 1) * sectors + 2), {}};
  const auto index = [&](int ring, int sector) {
    return ring == 0 ? 0 : ring == rings ? 1 : 2 + (ring - 1) * sectors + sector % sectors;
  };
  mesh.vertices.col(0) << 0, 0, 1;
  mesh.vertices.col(1) << 0, 0, -1;
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j) {
      const double a = M_PI * i / rings, b = 2 * M_PI * j / sectors;
      if (i > 0) {
        mesh.vertices.col(index(i, j)) << std::sin(a) * std::cos(b), std::sin(a) * std::sin(b),
            std::cos(a);
      }
      const int p = index(i, j), q = index(i + 1, j), r = index(i + 1, j + 1), s = index(i, j + 1);
      if (i + 1 < rings) triangles.push_back({p, q, r});
      if (i > 0) triangles.push_back({p, r, s});
    }
  }
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    mesh.triangles.col(k) = triangles[k];
  }
  return mesh;
}

}  // namespace graspless::fingertip
