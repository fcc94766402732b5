// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Groups of pixels above a region.
#pragma once

#include <cmath>
#include <vector>

#include "perception/regions.hpp"

namespace graspless::perception {

/// A pixel above a support.
struct Pixel {
  int view, u, v;
  float depth;            ///< as measured [m]
  float height;           ///< of a plane through the neighbours of the same surface [m]
  Eigen::Vector2f slope;  ///< of that plane along u and v [m]
  float raw;              ///< as measured [m]
  Eigen::Vector2f p;      ///< in S [m]
};

/// The rays of a view, in the frame S of a region.
class Rays {
 public:
  Rays(const Sighting& from, const Eigen::Isometry3d& X_WS);
  /// Where the ray of a pixel has a height [m] above the plane. On rays that are nearly level, and
  /// so have that height anywhere or never, the point at the measured depth z [m].
  Eigen::Vector3d at_height(double u, double v, double height, double z) const {
    constexpr double kLeastSlope = 0.05;
    const double slope = across_.x() * u + across_.y() * v + across_.z();
    const double there = std::abs(slope) > kLeastSlope ? (height - camera_) / slope : 0;
    return at_depth(u, v, there > 0 ? there : z);
  }
  Eigen::Vector3d at_depth(double u, double v, double z) const {
    return origin_ + directions_ * Eigen::Vector3d(u * z, v * z, z);
  }
  /// The pixel (u, v, 1), times its depth, in which a point is seen.
  Eigen::Vector3d pixel_of(const Eigen::Vector3d& p_S) const {
    return to_pixels_ * (p_S - origin_);
  }

 private:
  Eigen::Vector3d origin_;
  Eigen::Matrix3d directions_, to_pixels_;
  Eigen::RowVector3d across_;
  double camera_;
};

/// The pixels of one object.
struct Cluster {
  std::vector<Pixel> pixels;
  double footprint;  ///< size of a pixel on the object [m]
};

/// One flag for each pixel of every view.
using Claims = std::vector<Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// Groups the pixels above a region whose projections onto it are connected. Pixels that are
/// claimed are left out, and those of the clusters claimed. `regions` before this one are higher or
/// were searched before. `left_out` becomes the height of the highest pixels over the region that
/// are higher than `max_height` and so belong to no cluster [m]; 0 if there are hardly any.
std::vector<Cluster> clusters_over(const Region& region, const std::vector<Sighting>& sightings,
                                   const NoiseModel& noise, const Options& options, Claims& claims,
                                   double& left_out);

}  // namespace graspless::perception
