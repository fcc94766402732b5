// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/geometry/polygon.hpp"
#include "graspless/geometry/ray_image.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {

/// Heights over the plane z = 0 of a frame O, one for each square cell: the solid between them and
/// the plane. A vessel that is open at the top can be described
/// so; an overhang is filled.
struct GRASPLESS_API HeightMap {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< least x and y of the first cell [m]
  double cell = 0;                                   ///< side of a cell [m]
  /// Entry (i, j) is that of the cell from corner + cell (i, j) to corner + cell (i + 1, j + 1).
  /// 0: nothing is there [m].
  Eigen::ArrayXXd heights;
  /// Lowest height at which each cell was seen [m]: nobody knows what is below, but it counts as
  /// solid. Empty: the cells are known to be solid down to the plane.
  Eigen::ArrayXXd undersides = Eigen::ArrayXXd();

  /// Height at a point; 0 beyond the cells [m].
  double at(const Eigen::Vector2d& p_O) const { return of(heights, p_O); }
  /// Underside at a point; 0 beyond the cells, and if they are known to be solid [m].
  double underside_at(const Eigen::Vector2d& p_O) const {
    return undersides.size() > 0 ? of(undersides, p_O) : 0;
  }
  /// Least and largest height of the solid within `radius` of a point: of the cells whose centres
  /// are that near, and of the one at the point. Both are 0 if nothing is there [m].
  std::pair<double, double> range_near(const Eigen::Vector2d& p_O, double radius) const;

 private:
  double of(const Eigen::ArrayXXd& values, const Eigen::Vector2d& p_O) const;
};

/// Throws std::invalid_argument that names `field` unless a map has 1 to 10^6 cells, a side of at
/// least 0.1 mm, heights from 0 to kMaxLength, one of them at least kMinLength, and as many
/// undersides, if any, from 0 to their heights.
GRASPLESS_API void validate(const HeightMap& map, const std::string& field);

/// Boxes that fill a map, in O. Cells of nearly the same height share one: each box is as high as
/// the next multiple of `step` [m], but not higher than the highest cell. Throws
/// std::invalid_argument unless `step` is at least kMinLength.
GRASPLESS_API std::vector<PlacedShape> columns(const HeightMap& map, double step);

/// Heights of an object as cameras saw it. A cell is as high as its highest point. Where the
/// cameras saw no point, the object is as high as it may be: up to the lowest of the rays that pass
/// over the cell, one below the other, or up to the top. Nothing was seen of such a cell: its
/// underside is its height.
///
/// `points`: (3 x n) on the object, in O. `rays`: of the cameras, in O. `outline`: of the object,
/// in O; cells beyond its convex hull without points are 0. `top`: height of the object; `cell`:
/// side of a cell [m]. Where rays are sparse, this is an estimate: a ray clears the whole cell that
/// it passes, two cells high. Throws std::invalid_argument on points that are not finite, lengths
/// for which the map is not valid, or more than 2e7 voxels of this size.
GRASPLESS_API HeightMap seen_heights(const Eigen::Matrix3Xd& points,
                                     const std::vector<RayImage>& rays, const Polygon& outline,
                                     double top, double cell);

}  // namespace graspless::geometry
