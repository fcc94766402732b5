// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Collisions of a realization, by FCL alone.
#pragma once

#include <string>
#include <vector>

#include "graspless/collision/world.hpp"
#include "graspless/fingertip/problem.hpp"
#include "graspless/robot/robot.hpp"

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
  void add(const std::string& name, const std::vector<geometry::PlacedShape>& shapes,
           const Eigen::Isometry3d& X_WB);
  int body_of(const std::string& link) const;  // -1 for a link without shapes

  const robot::Robot& robot_;
  collision::World world_;
  std::vector<int> link_of_body_;
  int object_ = -1;
};

}  // namespace graspless::fingertip
