// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <utility>
#include <vector>

#include "graspless/collision/world.hpp"
#include "graspless/export.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::scene {

/// A robot among bodies. Bodies of the world are named after the robot's links (those that have shapes), then
/// whatever is added. Not shared between threads; copy it instead.
class GRASPLESS_API Scene {
 public:
  explicit Scene(const robot::Robot& robot);

  const robot::Robot& robot() const { return robot_; }
  collision::World& world() { return world_; }
  const collision::World& world() const { return world_; }

  /// Adds a body fixed in the world that no link may touch, except the root link and links rigid with it when
  /// `touches_base`. Returns its index in the world.
  int add_obstacle(const std::string& name, const std::vector<geometry::PlacedShape>& shapes,
                   const Eigen::Isometry3d& X_WB, bool touches_base = true);
  /// Adds a body that moves (see move_object, attach) and that no link may touch.
  int add_object(const std::string& name, const std::vector<geometry::PlacedShape>& shapes);
  void move_object(int body, const Eigen::Isometry3d& X_WO);
  /// The body follows `link` from now on; move_object or detach ends that. `touching` are links that may touch it.
  void attach(int body, int link, const Eigen::Isometry3d& X_LO, const std::vector<int>& touching);
  void detach(int body);

  /// Index in the world of a link's body; -1 for a link without shapes.
  int link_body(int link) const { return link_body_[link]; }

  /// Whether the robot at q is within its limits and nothing touches.
  bool is_free(const Eigen::VectorXd& q);
  /// As is_free(q), from poses already computed; limits are not looked at.
  bool is_free(const robot::Poses& X_WL);
  /// Whether the straight motion from q1 to q2 is free, seen at steps of at most `resolution` [rad or m] in any
  /// joint. Bodies other than links and attached ones stand still. Intervals that a bound on the motion of
  /// every link (Robot::reach) proves free are not stepped through.
  bool is_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double resolution = 0.01);
  /// The first touching pair at q, by name; empty names when free.
  std::pair<std::string, std::string> collision(const Eigen::VectorXd& q);

  /// Poses at the configuration last given to is_free(q) or collision(q).
  const robot::Poses& poses() const { return X_WL_; }

 private:
  void place(const robot::Poses& X_WL);
  bool is_interval_free(const Eigen::VectorXd& q1, const std::vector<double>& bounds1,
                        const Eigen::VectorXd& q2, const std::vector<double>& bounds2,
                        double resolution);

  struct Attachment {
    int body, link;
    Eigen::Isometry3d X_LO;
  };
  robot::Robot robot_;
  collision::World world_;
  robot::Poses X_WL_;
  std::vector<int> link_body_;
  std::vector<Attachment> attachments_;
};

}  // namespace graspless::scene
