// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Geometry>

#include "graspless/export.hpp"

namespace graspless::geometry {

/// Rays of a camera around an object. They show where the object is, and where it is open.
struct RayImage {
  /// Depth at which the ray of each pixel ends, along the optical axis [m]. Negative: the ray ends
  /// on the object, at minus this depth. Infinite: it passes the object. 0: unknown.
  Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> ends;
  Eigen::Matrix3d K = Eigen::Matrix3d::Identity();  ///< camera matrix of this image [pixels]
  /// Pose of the optical frame (x right, y down, z forward) in the frame of the object's points.
  Eigen::Isometry3d X_OC = Eigen::Isometry3d::Identity();
};

/// Throws std::invalid_argument that names `field` unless an image has 1 to 25 * 10^6 pixels, none
/// of which is not a number or minus infinity, a camera matrix without skew, and a rigid pose.
GRASPLESS_API void validate(const RayImage& rays, const std::string& field);

}  // namespace graspless::geometry
