// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/obstacle.hpp"
#include "graspless/collision/world.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::scene {

/// What a check() replays a plan in. Nothing here is shared with the searches: bodies and pairs of
/// its own, and FCL without the boxes in front.
class Replay {
 public:
  explicit Replay(const robot::Robot& robot);

  /// Adds a body that no link may touch, but for those rigid with the root when it `carries_base`.
  int add(const std::string& name, const collision::Solid& solid, bool carries_base);
  /// An obstacle, which may carry the base.
  int add(const collision::Obstacle& obstacle);

  collision::World& world() { return world_; }
  int num_links() const { return static_cast<int>(link_of_body_.size()); }  ///< the first bodies
  /// Index in the world of a link's body; -1 for a link without shapes.
  int body_of(const std::string& link) const;

  /// Names of touching pairs, "a - b", with the robot at q and the bodies where they are.
  std::vector<std::string> touching(const Eigen::VectorXd& q);
  std::vector<std::string> touching(const robot::Poses& X_WL);

 private:
  void add_links();

  robot::Robot robot_;
  collision::World world_;
  std::vector<int> link_of_body_;  // of the first bodies
};

}  // namespace graspless::scene
