// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::collision {

/// The distance from points to a triangle surface: what settles the clear cases before FCL is
/// asked.
///
/// Exact distances by CGAL's tree of boxes, built when it is first needed; bounds from a grid whose
/// cells are cut smaller and filled where they are asked (the distance changes by no more than one
/// moves). The grid has no end. Copies share the surface and have grids of their own, empty at
/// first: one copy a thread.
class GRASPLESS_API Clearance {
 public:
  /// `cell`: side of the grid's cells [m]. Throws std::invalid_argument when the mesh has no
  /// triangle or is not valid.
  explicit Clearance(const geometry::Mesh& mesh, double cell = 0.01);
  Clearance(const Clearance& other);
  Clearance& operator=(const Clearance& other);
  Clearance(Clearance&&) noexcept;
  Clearance& operator=(Clearance&&) noexcept;
  ~Clearance();

  /// Exact up to rounding [m].
  double distance(const Eigen::Vector3d& point) const;
  /// Bounds on distance(point) at most a cell's diagonal apart [m], from the grid.
  struct Bounds {
    double lower, upper;
  };
  Bounds bounds(const Eigen::Vector3d& point);
  /// Bounds just near enough to tell on which side of `threshold` [m] the distance lies, and how
  /// much larger it is to a factor of eight; the distance itself where no cell can tell.
  Bounds bounds(const Eigen::Vector3d& point, double threshold);
  /// Bounds that tell on which side of `threshold` the distance lies or are a cell's diagonal
  /// apart.
  Bounds rough_bounds(const Eigen::Vector3d& point, double threshold);

 private:
  Bounds exactly(const Eigen::Vector3d& point) const;

  struct Surface;
  struct Grid;
  std::shared_ptr<const Surface> surface_;
  std::unique_ptr<Grid> grid_;
};

}  // namespace graspless::collision
