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

/// World in which a check() replays a plan. It shares nothing with the searches: it has bodies and
/// pairs of its own, and FCL alone decides what touches (see World::all_collisions()).
class Replay {
 public:
  explicit Replay(const robot::Robot& robot);

  /// Adds a body that no link may touch. With `carries_base`, links rigid with the root may.
  int add(const std::string& name, const collision::Solid& solid, bool carries_base);
  /// Adds an obstacle, which may carry the base.
  int add(const collision::Obstacle& obstacle);

  collision::World& world() { return world_; }
  int num_links() const {
    return static_cast<int>(link_of_body_.size());
  }  ///< the first bodies of the world
  /// Index in the world of a link's body; -1 for a link without shapes.
  int body_of(const std::string& link) const;
  int link_of(int body) const { return link_of_body_[body]; }
  const robot::Robot& robot() const { return robot_; }

  /// Moves the links' bodies.
  void place(const robot::Poses& X_WL);

  /// Returns the names of touching pairs, "a - b", with the robot at q and the other bodies at
  /// their current poses.
  std::vector<std::string> touching(const Eigen::VectorXd& q);
  std::vector<std::string> touching(const robot::Poses& X_WL);

 private:
  void add_links();

  robot::Robot robot_;
  collision::World world_;
  std::vector<int> link_of_body_;  // link index of each of the first bodies
};

}  // namespace graspless::scene
