// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays beside an object, which show where it is open.
#pragma once

#include <vector>

#include "graspless/geometry/ray_image.hpp"

#include "perception/footprint.hpp"

namespace graspless::perception {

/// The rays around a cluster in each view that has some of its pixels, with poses in O. Rays that
/// reach the support, or what is below it, pass the object.
///
/// A support seen through a hole is as high as elsewhere. The bottom of a dish is higher, but
/// possibly not by enough to be told from the support pixel by pixel. So the mean height of each
/// patch of the support decides, and rays that end on a doubtful patch are unknown. So are those
/// that end above the support within the object's outline: a bottom may be taken for an object.
std::vector<geometry::RayImage> rays_around(
    const Cluster& cluster, const std::vector<PixelSet>& sets, const Eigen::Isometry3d& X_WS,
    const Eigen::Isometry3d& X_WO, const std::vector<Sighting>& sightings, const NoiseModel& noise,
    const Options& options, double height_error);

}  // namespace graspless::perception
