// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Polygons from the boundaries of rasters.
#pragma once

#include <vector>

#include "graspless/geometry/polygon.hpp"
#include "graspless/perception/scene.hpp"

#include "perception/raster.hpp"

namespace graspless::perception {

struct LabelledPolygon {
  geometry::Polygon polygon;
  std::vector<EdgeLabel> labels;  ///< one per edge
};

/// Simplifies a boundary whose steps have labels: runs of one label become polylines within
/// `tolerance` [m] (Douglas, Peucker 1973), whose edges are then fitted to the steps by least
/// squares. Runs of real edges shorter than `least_real` [m] take the label beside them.
LabelledPolygon fitted_polygon(const Raster& mask, const std::vector<Step>& boundary,
                               std::vector<EdgeLabel> labels, double tolerance, double least_real);

/// Simplifies a boundary to within `tolerance` [m].
geometry::Polygon simple_polygon(const Raster& mask, const std::vector<Step>& boundary,
                                 double tolerance);

}  // namespace graspless::perception
