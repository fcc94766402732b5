// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "perception/objects.hpp"

namespace graspless::perception {

/// Builds a scene, plane by plane.
class SceneBuilder {
 public:
  SceneBuilder(const std::vector<Sight>& sights, const NoiseModel& noise, const Options& options);

  /// Adds the supports in a plane, and what is on them. Planes are added from the highest to the
  /// lowest: what stands on a shelf is not an object of the board below.
  void add(const Plane& plane);
  Scene finish();

 private:
  Support support_of(const Plane& plane, const Region& region,
                     const std::vector<Sighting>& sightings);
  void add_objects(const Region& region, const Support& support,
                   const std::vector<Sighting>& sightings);
  void claim_support(const Region& region, const std::vector<Sighting>& sightings);
  void name_supports();
  void name_objects();
  void warn_of_heights();

  const std::vector<Sight>& sights_;
  const NoiseModel& noise_;
  const Options& options_;
  Claims claims_;
  Scene scene_;
  std::vector<double> areas_, left_out_;  // of the supports
  int number_ = 0;
};

/// True if something lies on a support, or there is no other one.
bool is_used(const Support& support, const Scene& scene);

}  // namespace graspless::perception
