// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "graspless/geometry/height_map.hpp"
#include "graspless/watch.hpp"

#include "geometry/convex_hull.hpp"
#include "text.hpp"

namespace graspless::geometry {

using Eigen::ArrayXXd, Eigen::Index, Eigen::Vector2d, Eigen::Vector3d;

namespace {

constexpr double kBin = 2;       // height of a voxel, in cells: neighbouring rays are farther apart
                                 // than a cell where they are steep
constexpr double kStride = 0.5;  // along a ray, in cells

/// Voxels over the cells of a map, from the top down, with the lowest ray through each.
class Passed {
 public:
  Passed(const HeightMap& map, double top)
      : map_(map),
        top_(top),
        bin_(kBin * map.cell),
        lowest_(static_cast<std::size_t>(std::ceil(top / bin_)),
                ArrayXXd::Constant(map.heights.rows(), map.heights.cols(),
                                   std::numeric_limits<double>::infinity())) {}

  void add(const RayImage& image) {
    const Eigen::Matrix3d to_ray = image.X_OC.linear() * image.K.inverse();
    const Vector3d eye = image.X_OC.translation();
    for (Index v = 0; v < image.ends.rows(); ++v) {
      poll();
      for (Index u = 0; u < image.ends.cols(); ++u) {
        auto end = std::abs(static_cast<double>(image.ends(v, u)));
        if (end == 0 && image.clear.size() > 0) end = static_cast<double>(image.clear(v, u));
        if (end == 0) continue;  // unknown
        const Vector3d along = to_ray * Vector3d(static_cast<double>(u), static_cast<double>(v), 1);
        if (along.z() < 0) march(eye, along, end);
      }
    }
  }

  /// Height up to which the object may reach in a cell.
  double bound(Index i, Index j) const {
    double height = top_;
    for (const ArrayXXd& layer : lowest_) {
      if (!(layer(i, j) < top_)) break;
      height = layer(i, j);
    }
    return height;
  }

 private:
  /// Notes a ray from the height of the top to its end or to the plane.
  void march(const Vector3d& eye, const Vector3d& along, double end) {
    double from = std::max(0.0, (top_ - eye.z()) / along.z()),
           to = std::min(end, -eye.z() / along.z());
    for (int k = 0; k < 2; ++k) {  // over the map
      const double size =
          map_.cell * static_cast<double>(k == 0 ? map_.heights.rows() : map_.heights.cols());
      const double low = (map_.corner[k] - eye[k]) / along[k], high = low + size / along[k];
      if (std::isnan(low) || std::isinf(low)) continue;  // parallel to this side: note() decides
      from = std::max(from, std::min(low, high));
      to = std::min(to, std::max(low, high));
    }
    if (!(to > from) || !std::isfinite((to - from) * along.norm())) return;
    const auto steps =
        static_cast<int>(std::ceil((to - from) * along.norm() / (kStride * map_.cell)));
    for (int k = 0; k <= steps; ++k) note(eye + (from + (to - from) * k / steps) * along);
  }

  void note(const Vector3d& p) {
    const double x = (p.x() - map_.corner.x()) / map_.cell,
                 y = (p.y() - map_.corner.y()) / map_.cell;
    if (!(x >= 0 && y >= 0 && x < static_cast<double>(map_.heights.rows()) &&
          y < static_cast<double>(map_.heights.cols())))
      return;
    const double layer =
        std::clamp((top_ - p.z()) / bin_, 0.0, static_cast<double>(lowest_.size() - 1));
    double& lowest =
        lowest_[static_cast<std::size_t>(layer)](static_cast<Index>(x), static_cast<Index>(y));
    lowest = std::min(lowest, std::max(p.z(), 0.0));
  }

  const HeightMap& map_;
  double top_, bin_;
  std::vector<ArrayXXd> lowest_;
};

HeightMap empty_map(const Eigen::Matrix3Xd& points, const Polygon& outline, double top,
                    double cell) {
  if (!points.allFinite()) throw std::invalid_argument("points must be finite");
  require(cell > 0, "cell", cell, "must be positive");
  const Eigen::Matrix2Xd& ring = outline.vertices();
  Vector2d low = ring.rowwise().minCoeff(), high = ring.rowwise().maxCoeff();
  if (points.cols() > 0) {
    low = low.cwiseMin(points.topRows<2>().rowwise().minCoeff());
    high = high.cwiseMax(points.topRows<2>().rowwise().maxCoeff());
  }
  HeightMap map;
  map.corner = low;
  map.cell = cell;
  const Vector2d count = ((high - low) / cell).array().floor() + 1;
  constexpr double kMost = 1e3;  // cells along a side
  if (!(count.maxCoeff() <= kMost))
    throw std::invalid_argument("cell is too small for an object of " +
                                figure((high - low).maxCoeff()) + " m: " + figure(cell) + " m");
  constexpr double kMostVoxels = 2e7;
  if (!(top > 0 && count.prod() * std::ceil(top / (kBin * cell)) <= kMostVoxels))
    throw std::invalid_argument("top must be positive, and have at most 2e7 voxels of " +
                                figure(cell) + " m below it, not " + figure(top) + " m");
  map.heights.setZero(static_cast<Index>(count.x()), static_cast<Index>(count.y()));
  return map;
}

}  // namespace

HeightMap seen_heights(const Eigen::Matrix3Xd& points, const std::vector<RayImage>& rays,
                       const Polygon& outline, double top, double cell) {
  HeightMap map = empty_map(points, outline, top, cell);
  map.undersides.setConstant(map.heights.rows(), map.heights.cols(), top);
  for (Index k = 0; k < points.cols(); ++k) {
    const Vector2d at = (points.col(k).head<2>() - map.corner) / cell;
    const auto i = static_cast<Index>(at.x()), j = static_cast<Index>(at.y());
    const double z = std::clamp(points(2, k), 0.0, top);
    map.heights(i, j) = std::max(map.heights(i, j), z);
    map.undersides(i, j) = std::min(map.undersides(i, j), z);
  }
  Passed passed(map, top);
  for (const RayImage& image : rays) {
    validate(image, "rays");
    passed.add(image);
  }
  const Polygon hull(convex_outline(outline.vertices()));
  for (Index i = 0; i < map.heights.rows(); ++i) {
    poll();
    for (Index j = 0; j < map.heights.cols(); ++j) {
      const Vector2d middle =
          map.corner + cell * Vector2d(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
      if (map.heights(i, j) > 0 || !hull.contains(middle)) continue;
      map.heights(i, j) = map.undersides(i, j) = passed.bound(i, j);
    }
  }
  map.undersides = map.undersides.min(map.heights);
  validate(map, "heights");
  return map;
}

}  // namespace graspless::geometry
