// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"

namespace graspless::geometry {

/// Rays of a camera around an object. They show where the object is, and where it is open.
struct RayImage {
  using Ends = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  /// Depth at which the ray of each pixel ends, along the optical axis [m]. Negative: the ray ends
  /// on the object, at minus this depth. Infinite: it passes the object. 0: unknown.
  Ends ends;
  /// Depth up to which a ray of unknown end met nothing [m]; 0: nobody knows. Empty: 0 everywhere.
  /// The thin bottom of a vessel is as high as its support, and may be either.
  Ends clear = Ends();
  Eigen::Matrix3d K = Eigen::Matrix3d::Identity();  ///< camera matrix of this image [pixels]
  /// Pose of the optical frame (x right, y down, z forward) in the frame of the object's points.
  Eigen::Isometry3d X_OC = Eigen::Isometry3d::Identity();
};

/// Throws std::invalid_argument that names `field` unless an image has 1 to 25 * 10^6 pixels, none
/// of which is not a number or minus infinity, `clear` of the same size or empty, with depths that
/// are finite and not negative, a camera matrix without skew, and a rigid pose.
GRASPLESS_API void validate(const RayImage& rays, const std::string& field);

/// Rays of cameras that saw an object, from its points (3 x n, in O) and the positions of the
/// cameras (3 x k, in O) [m], where no depth images are left: a ray ends on the object if a point
/// is within two spacings of it in the image, and passes it otherwise. The cloud must have all that
/// the cameras saw of the object, and nothing else. Throws std::invalid_argument unless there are
/// at least 20 finite points, all within 60 degrees of the direction to their middle.
GRASPLESS_API std::vector<RayImage> rays_from_viewpoints(const Eigen::Matrix3Xd& points,
                                                         const Eigen::Matrix3Xd& viewpoints);

}  // namespace graspless::geometry
