// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/complex.hpp"

#include "clasp/certificate/tight_cycle.hpp"
#include "collision/clearance_tree.hpp"

namespace graspless::clasp {

/// A closed curve inside an object, and the radius of a ball that fits into the object everywhere
/// along it.
struct CoreLoop {
  Eigen::Matrix3Xd points;  // corners, 3 x n in O [m]
  double radius = 0;        // [m]
};

/// The material of an object: the tetrahedra of the Delaunay triangulation that the triangles of
/// the surface shut off from the outside.
class Core {
 public:
  explicit Core(const geometry::Complex& complex);

  /// The thickest loop that is linked with a closed curve, 3 x n in O, as far as found; nothing if
  /// there is none.
  CoreLoop loop(const Eigen::Matrix3Xd& curve) const;
  /// True for a point of the material.
  bool contains(const Eigen::Vector3d& p) const;

 private:
  struct Thin {
    Eigen::Vector3d at;
    double clear;  // distance from the boundary, or a bound on it [m]
    int near = 0;  // a triangle of the boundary nearby
  };

  void cast_shadows();
  Thin thin(const Eigen::Vector3d& p, int hint) const;
  Thin thinnest(const Thin& a, const Thin& b, double enough) const;
  Thin centered(Thin point, Eigen::Vector3d along) const;
  void center(std::vector<Thin>& loop) const;
  std::vector<Thin> resampled(const std::vector<Thin>& loop, double spacing) const;
  double thicken(std::vector<Thin>& loop) const;

  geometry::Mesh boundary_;
  // Boxes of its triangles, seen along the ray of contains(): low and high in each direction [m].
  Eigen::ArrayX4d shadows_;
  std::unique_ptr<collision::ClearanceTree> surface_;  // of the boundary; nothing without material
  Eigen::Matrix3Xd points_;         // centres of the tetrahedra, and of the triangles between them
  std::vector<SpatialEdge> edges_;  // from each tetrahedron to its triangles; width: -clearance
};

}  // namespace graspless::clasp
