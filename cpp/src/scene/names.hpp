// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <stdexcept>
#include <string>

#include "graspless/robot/robot.hpp"

namespace graspless::scene {

/// Names that obstacles may not have: those of a robot's links, and `bodies`. Throws
/// std::invalid_argument if a link with collision shapes has the name of one of the bodies.
inline std::set<std::string> taken_names(const robot::Robot& robot, std::set<std::string> bodies) {
  for (const robot::LinkShape& shape : robot.shapes()) {
    const std::string& link = robot.frame_names()[shape.link];
    if (bodies.count(link) != 0) {
      throw std::invalid_argument(
          "robot: link '" + link +
          "' has the name of another body of the plan: rename it in the URDF");
    }
  }
  bodies.insert(robot.frame_names().begin(), robot.frame_names().end());
  return bodies;
}

}  // namespace graspless::scene
