// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "graspless/fingertip/object.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::fingertip {

/// The mesh with each vertex once, closed and outward. Throws std::invalid_argument, naming `what`,
/// when it is too large, not closed, not oriented throughout or without volume. A piece may be
/// inside out only where it bounds a cavity.
geometry::Mesh closed_mesh(const geometry::Mesh& mesh, const std::string& what);

/// The triangle across each edge (3 x triangles) of a closed mesh.
Eigen::Matrix3Xi neighbours(const geometry::Mesh& mesh);

/// Refuses pieces of a closed mesh whose triangles face inwards, unless they bound cavities. Pieces
/// of less volume pass [m^3].
void require_outward(const geometry::Mesh& mesh, double least_volume, const std::string& what);

/// Of the solid that a closed outward mesh bounds, per unit of density.
struct MassProperties {
  double volume = 0;                                  // [m^3]
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   // [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the center [m^5]
};
MassProperties mass_properties(const geometry::Mesh& mesh);

/// The flat parts of a closed outward mesh: neighbouring triangles in one plane, to a small part of
/// `size` [m]. In the order of their first triangles.
std::vector<Face> find_faces(const geometry::Mesh& mesh, double size);

}  // namespace graspless::fingertip
