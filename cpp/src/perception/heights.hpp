// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of the pixels of a view above a plane.
#pragma once

#include <cstdint>

#include "perception/planes.hpp"
#include "perception/sight.hpp"

namespace graspless::perception {

/// Where a pixel's point lies.
enum class Level : std::uint8_t { missing, below, level, above };

struct Heights {
  /// [m]; of pixels near the plane the mean of a window.
  DepthImage height;
  Eigen::Array<Level, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> level;
  Eigen::RowVector3d across;  ///< height = z across (u, v, 1) + camera
  double camera;              ///< height of the camera [m]
  int window;                 ///< side of the windows [pixels]

  /// Standard deviation of the height of one pixel.
  double deviation(const NoiseModel& noise, double z, double u, double v) const {
    return noise(z) * std::abs(across.dot(Eigen::RowVector3d(u, v, 1)));
  }
};

/// Pixels farther than 4.5 deviations from the plane are above or below it. Among the others, which
/// are averaged over windows, those whose mean is significant.
Heights heights_over(const Sight& sight, const Plane& plane, const NoiseModel& noise,
                     const Options& options);

/// Least thickness that an object of the size of a window needs to be found, at a point of the
/// plane [m].
double least_thickness(const Sight& sight, const Heights& heights, const NoiseModel& noise,
                       const Options& options, const Eigen::Vector3d& p_W);

}  // namespace graspless::perception
