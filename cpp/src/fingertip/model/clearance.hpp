// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Geometry>

#include "graspless/collision/world.hpp"
#include "graspless/fingertip/problem.hpp"
#include "graspless/mechanics/contact.hpp"

namespace graspless::fingertip {

/// Tests that a fingertip's sphere, or the object, is clear of planes and obstacles.
class Clearance {
 public:
  explicit Clearance(const Problem& problem);

  /// A sphere with its centre there; it may touch a plane.
  bool is_clear(const Eigen::Vector3d& center_W);
  /// The obstacle that the object touches at a pose; empty: none.
  std::string obstacle_at(const Eigen::Isometry3d& X_WO);

  // Ways of unit time with a body twist: at `samples` times, each in the middle of its part of the
  // way, and so often between them that obstacles are not stepped over.

  /// The obstacle that the object touches on a way; empty: none. No point of it moves by more than
  /// a fiftieth of its size between two looks.
  std::string obstacle_along(const Eigen::Isometry3d& X_WO, const mechanics::Vector6d& twist_O,
                             int samples = 1);
  /// A sphere that moves with the object is clear of obstacles. It moves by half its radius at most
  /// between two looks.
  bool is_off_obstacles_along(const Eigen::Isometry3d& X_WO, const mechanics::Vector6d& twist_O,
                              const Eigen::Vector3d& center_O, int samples);

 private:
  bool is_off_obstacles(const Eigen::Vector3d& center_W);

  const Problem& problem_;
  collision::World for_sphere_, for_object_;
  int sphere_ = -1, object_ = -1;
};

}  // namespace graspless::fingertip
