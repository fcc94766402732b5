// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/collision/world.hpp"
#include "graspless/fingertip/problem.hpp"
#include "graspless/mechanics/contact.hpp"

#include "fingertip/model/locations.hpp"

namespace graspless::fingertip {

/// Whether a fingertip's sphere, or the object, is clear of planes and obstacles.
class Clearance {
 public:
  explicit Clearance(const Problem& problem);

  /// A sphere with its centre there; it may touch a plane.
  bool is_clear(const Eigen::Vector3d& center_W);
  /// The obstacle that the object touches at a pose; empty: none.
  std::string obstacle_at(const Eigen::Isometry3d& X_WO);

 private:
  const Problem& problem_;
  collision::World for_sphere_, for_object_;
  int sphere_ = -1, object_ = -1;
};

/// How fast a sphere's centre moves with the object's twist [m per unit of time].
double sphere_speed(const mechanics::Vector6d& twist_O, const Location& location);

}  // namespace graspless::fingertip
