// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {

/// The mesh of a box centred at the origin, sides along the axes [m].
inline Mesh box_mesh(const Eigen::Vector3d& size) {
  Mesh mesh{Eigen::Matrix3Xd(3, 8), Eigen::Matrix3Xi(3, 12)};
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.col(i) =
        size.cwiseProduct(Eigen::Vector3d(i & 1 ? .5 : -.5, i & 2 ? .5 : -.5, i & 4 ? .5 : -.5));
  }
  mesh.triangles << 0, 0, 1, 1, 0, 0, 2, 2, 0, 0, 4, 4,  //
      4, 6, 3, 7, 1, 5, 6, 7, 2, 3, 5, 7,                //
      6, 2, 7, 5, 5, 4, 7, 3, 3, 1, 7, 6;
  return mesh;
}

}  // namespace graspless::geometry
