// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Collisions of a realization, by FCL alone.
#pragma once

#include <string>
#include <vector>

#include "graspless/fingertip/problem.hpp"
#include "graspless/robot/robot.hpp"

#include "scene/replay.hpp"

namespace graspless::fingertip {

/// The robot's links, planes, obstacles and the object as bodies of a world of its own.
class RealizeReplay {
 public:
  RealizeReplay(const Problem& problem, const robot::Robot& robot);

  /// A link that may reach `depth` [m] into the object against the direction out_O.
  struct Allowed {
    std::string link;
    Eigen::Vector3d out_O;
    double depth;
  };
  /// "a - b" for every pair that touches at these poses.
  std::vector<std::string> touching(const robot::Poses& X_WL, const Eigen::Isometry3d& X_WO,
                                    const std::vector<Allowed>& allowed);

 private:
  scene::Replay replay_;
  int object_ = -1;
};

}  // namespace graspless::fingertip
