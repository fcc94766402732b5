// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {

/// Draws random points on the surface of a shape, uniform by area.
class SurfaceSampler {
 public:
  struct Point {
    Eigen::Vector3d p_B;
    Eigen::Vector3d
        outward_B;  ///< outward unit normal; zero on a mesh, whose orientation is unknown
  };

  explicit SurfaceSampler(const PlacedShape& placed);

  double area() const { return area_; }  ///< [m^2]
  Point draw(std::mt19937_64& rng) const;

 private:
  void set(const Box& box);
  void set(const Sphere& sphere) { set_round(sphere.radius, 0); }
  void set(const Capsule& capsule) { set_round(capsule.radius, capsule.length); }
  void set(const Convex& convex);
  void set(const Mesh& mesh);
  void set_round(double radius, double length);
  Point draw_round(std::mt19937_64& rng) const;
  Point draw_triangle(std::mt19937_64& rng) const;

  Eigen::Isometry3d X_BG_;
  double area_ = 0;
  double radius_ = 0, length_ = 0;
  Mesh mesh_;
  bool has_outside_ = true;              // false for a mesh
  std::vector<double> cumulative_area_;  // of the mesh's triangles
};

/// Uniform in [0, 1), the same on every platform.
inline double draw_uniform(std::mt19937_64& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

}  // namespace graspless::geometry
