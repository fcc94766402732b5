// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The dominant planes of all cells, by a robust fit.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "perception/sight.hpp"

namespace graspless::perception {

/// Points p with n_W p + offset = 0. The normal points to the camera.
struct Plane {
  Eigen::Vector3d n_W;
  double offset;
  Eigen::Vector3d center_W;  ///< centroid of its cells
  double area;               ///< of its cells [m^2]
  double height_error, angle_error;
  double noise_scale;  ///< measured noise, divided by the expected one
  std::vector<Cell> cells;

  double above(const Eigen::Vector3d& p_W) const { return n_W.dot(p_W) + offset; }
};

/// Finds planes whose normals are within `max_tilt` of vertical, up or, if `is_below`, down: from
/// the one with the largest area to those of `min_area`. RANSAC on triples of cells, then a
/// least-squares fit.
std::vector<Plane> find_planes(std::vector<Cell> cells, const Options& options, bool is_below);

}  // namespace graspless::perception
