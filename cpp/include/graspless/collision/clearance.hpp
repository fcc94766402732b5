// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::collision {

class ClearanceCells;
class ClearanceTree;

/// Distance from points to a triangle surface. Decides the clear cases before FCL is called.
///
/// Exact distances come from a tree of boxes, which is built at the first call. Bounds come from an
/// unlimited grid whose cells are subdivided and filled on demand: moving a point changes its
/// distance by at most the length of the move. Not thread-safe: give each thread a copy. Copies
/// share the surface and start with an empty grid.
class GRASPLESS_API Clearance {
 public:
  /// `cell`: side of the grid's cells [m]. Throws std::invalid_argument if the mesh is not valid or
  /// has no triangle.
  explicit Clearance(const geometry::Mesh& mesh, double cell = 0.01);
  Clearance(const Clearance& other);
  Clearance& operator=(const Clearance& other);
  Clearance(Clearance&&) noexcept;
  Clearance& operator=(Clearance&&) noexcept;
  ~Clearance();
  /// A copy that begins with the cells of this one.
  Clearance with_cells() const;

  /// Distance of a point to the surface, exact up to rounding; infinite if it is above `limit` [m].
  double distance(const Eigen::Vector3d& point,
                  double limit = std::numeric_limits<double>::infinity()) const;
  /// Bounds on distance(point) [m].
  struct Bounds {
    double lower, upper;
  };
  /// Returns bounds that tell on which side of `threshold` [m] the distance lies, and if it is
  /// larger, by how much to a factor of eight. Returns the exact distance if no cell can tell.
  Bounds bounds(const Eigen::Vector3d& point, double threshold);
  /// Returns bounds that tell on which side of `threshold` [m] the distance lies, or are a cell's
  /// diagonal apart.
  Bounds rough_bounds(const Eigen::Vector3d& point, double threshold);

 private:
  Clearance(std::shared_ptr<const ClearanceTree> tree, std::unique_ptr<ClearanceCells> cells);
  Bounds exactly(const Eigen::Vector3d& point) const;

  std::shared_ptr<const ClearanceTree> tree_;
  std::unique_ptr<ClearanceCells> cells_;
};

}  // namespace graspless::collision
