// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Connected pieces of a plane, and what the rays saw at every place of it.
#pragma once

#include <cstdint>
#include <vector>

#include "perception/contour.hpp"
#include "perception/heights.hpp"

namespace graspless::perception {

/// Knowledge of a cell of a plane. The largest value of all views counts.
enum class Ground : std::uint8_t { outside, unknown, hidden, passed, seen };

/// A view with its heights over a plane.
struct Sighting {
  const Sight* sight;
  Heights heights;
};

/// A connected piece of a plane.
struct Region {
  Eigen::Isometry3d X_WS;
  Raster ground;  ///< values of Ground
  Raster inside;  ///< 1: in the piece, or enclosed by it
  LabelledPolygon outline;
  double area;  ///< of the cells that were seen [m^2]
};

/// Projects the cells of the plane into all views, and returns the pieces of at least the options'
/// area, from the largest to the smallest.
std::vector<Region> regions_of(const Plane& plane, const std::vector<Sighting>& sightings,
                               const NoiseModel& noise, const Options& options);

/// Indices of the cells of the plane that the region may go on to, as nothing was seen below the
/// plane between them.
std::vector<std::size_t> joined_to(const Region& region);

}  // namespace graspless::perception
