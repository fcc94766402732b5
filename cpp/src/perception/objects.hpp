// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures of objects, and the space that they hide.
#pragma once

#include <optional>
#include <vector>

#include "perception/clusters.hpp"

namespace graspless::perception {

/// Measures an object; none if its visible area is less than the options'. Its name stays empty.
std::optional<Object> measure(const Cluster& cluster, const Region& region, const Support& support,
                              const std::vector<Sighting>& sightings, const NoiseModel& noise,
                              const Options& options);

/// The space behind a cluster that the rays of its views do not reach: wedges between the support
/// and the highest rays that the object stops.
std::vector<geometry::Convex> shadows(const Cluster& cluster, const Region& region,
                                      const std::vector<Sighting>& sightings);

/// Boxes over the patches of a region that have no depth, and that no object hides.
std::vector<geometry::Convex> patches(const Region& region, const Options& options);

}  // namespace graspless::perception
