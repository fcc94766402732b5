// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A depth image made ready: thinned, without flying pixels, and cut into cells with a plane each.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "graspless/perception/scene.hpp"

namespace graspless::perception {

/// Standard deviation of a depth.
struct NoiseModel {
  double constant, quadratic;
  double scale = 1;  ///< factor that was measured
  double operator()(double z) const { return scale * (constant + quadratic * z * z); }
};

/// One view. `depth` is 0 where the camera gave nothing and where a pixel hangs between surfaces.
struct Sight {
  DepthImage depth;
  Eigen::Matrix3d K;
  Eigen::Isometry3d X_WC;
  int stride;     ///< of the pixels that were read
  double median;  ///< of all depths [m]; 0: there are none
  double share;   ///< of the pixels that have a depth
  double step;    ///< between the depths that the camera can express [m]; 0: none is noticeable

  int width() const { return static_cast<int>(depth.cols()); }
  int height() const { return static_cast<int>(depth.rows()); }
};

/// Reads every stride-th pixel of a view, so that at most `max_pixels` are left, and removes flying
/// pixels: those that are alike fewer than two of their four neighbours.
Sight prepare(const View& view, const NoiseModel& noise, std::int64_t max_pixels);

/// Largest difference of depth between neighbouring pixels of one surface [m].
double largest_step(const Sight& sight, const NoiseModel& noise, double z);

/// A square of pixels that one plane fits.
struct Cell {
  Eigen::Vector3d p_W, n_W;  ///< centre, and unit normal towards the camera
  double area;               ///< [m^2]
  double deviation;          ///< standard error of the centre along the ray [m]
  double roughness;          ///< measured deviation of the pixels, divided by the expected one
  double depth;              ///< of the centre [m]
  int row, column, view;
};

/// Fits planes to all squares of 16 x 16 pixels. A plane is linear in inverse depth: 1 / z = a u +
/// b v + c.
std::vector<Cell> planar_cells(const Sight& sight, int view, const NoiseModel& noise);

}  // namespace graspless::perception
