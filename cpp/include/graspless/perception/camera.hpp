// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "graspless/export.hpp"

namespace graspless::perception {

/// Depths of all pixels [m], along the optical axis. 0 or not finite: no measurement.
using DepthImage = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// One index per pixel; -1: none.
using LabelImage = Eigen::Array<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A pinhole camera without distortion. Its frame C has x right, y down and z forward. A point
/// p_CP is seen at the pixel (u, v, 1) = K p_CP / z; whole numbers are centres of pixels.
struct Camera {
  int width = 640;   ///< number of columns
  int height = 480;  ///< number of rows
  Eigen::Matrix3d K =
      (Eigen::Matrix3d() << 554.256258422, 0, 319.5, 0, 554.256258422, 239.5, 0, 0, 1).finished();
};

/// Returns a camera with square pixels, the principal point in the middle, and this horizontal
/// field of view [rad]. Throws std::invalid_argument unless the size is positive and the angle lies
/// in (0, pi).
GRASPLESS_API Camera camera_with_view(int width, int height, double angle);

/// Throws std::invalid_argument that names the field unless the size lies in [16, 20000] pixels, K
/// is that of a pinhole camera without skew, its principal point lies in the middle 80 % of the
/// image, and its field of view between 5 and 170 degrees.
GRASPLESS_API void validate(const Camera& camera);

}  // namespace graspless::perception
