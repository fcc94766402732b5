// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/world.hpp"
#include "graspless/export.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::scene {

/// A robot among bodies. Bodies of the world are named after the robot's links (those that have
/// shapes), then whatever is added. Links are tested against one another (but for
/// Robot::ignored_pairs) and against every obstacle and object; obstacles and objects are tested
/// against one another only where world().add_pair says so. Allowances go through
/// world().allow_contact. Not shared between threads; copy it instead: a copy costs microseconds.
class GRASPLESS_API Scene {
 public:
  explicit Scene(const robot::Robot& robot);

  const robot::Robot& robot() const { return robot_; }
  collision::World& world() { return world_; }
  const collision::World& world() const { return world_; }

  /// Adds a body fixed in the world that no link may touch, except the root link and links rigid
  /// with it when `touches_base`. Returns its index in the world.
  int add_obstacle(const std::string& name, const std::vector<geometry::PlacedShape>& shapes,
                   const Eigen::Isometry3d& X_WB, bool touches_base = true);
  int add_obstacle(const std::string& name, const collision::Solid& solid,
                   const Eigen::Isometry3d& X_WB, bool touches_base = true);
  /// Adds a body that moves (see move_object, attach) and that no link may touch.
  int add_object(const std::string& name, const std::vector<geometry::PlacedShape>& shapes);
  int add_object(const std::string& name, const collision::Solid& solid);
  void move_object(int body, const Eigen::Isometry3d& X_WO);
  /// The body follows `link` from now on; move_object or detach ends that and leaves it where it
  /// is. `touching` are links that may touch it meanwhile. Throws std::invalid_argument when the
  /// body is a link's or there is no such link.
  void attach(int body, int link, const Eigen::Isometry3d& X_LO, const std::vector<int>& touching);
  void detach(int body);

  /// Index in the world of a link's body; -1 for a link without shapes.
  int link_body(int link) const { return link_body_[link]; }

  /// Whether the robot at q is within its limits and nothing touches.
  bool is_free(const Eigen::VectorXd& q);
  /// As is_free(q), from poses already computed; limits are not looked at.
  bool is_free(const robot::Poses& X_WL);
  /// Whether the straight motion from q1 to q2, both within the limits, is free: what is_free(q)
  /// would say at its ends and at even steps between them of at most `resolution` [rad or m] in any
  /// joint. Stretches that a bound on the motion of every pair (Robot::reach) proves free all along
  /// are not stepped through.
  bool is_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double resolution = 0.01);
  /// The first touching pair at q, by name; empty names when free. Limits are not looked at.
  std::pair<std::string, std::string> collision(const Eigen::VectorXd& q);

  /// Poses at the configuration last looked at: the q of is_free(q) or collision(q).
  const robot::Poses& poses() const { return X_WL_; }

 private:
  struct Attachment {
    int body, link;
    Eigen::Isometry3d X_LO;
    std::vector<std::pair<int, int>> suspended;  // pairs that are not tested meanwhile
  };
  /// A pair that is not yet known to stay apart over a stretch of motion.
  struct OpenPair {
    int index;      // in the world's pairs
    double motion;  // bound on how far its bodies move towards one another in one step [m]
    double bound_first, bound_last;  // on their distance at the ends of the stretch [m]
    double bound_middle = 0;
  };

  void place(const robot::Poses& X_WL);
  void place(const Eigen::VectorXd& q);
  void update_motion_bounds();
  bool open_pairs(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, int steps);
  void keep_open(const OpenPair& pair, int steps);
  bool is_stretch_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& step, int first, int last,
                       std::size_t begin);

  robot::Robot robot_;
  collision::World world_;
  robot::Poses X_WL_;
  std::vector<int> link_body_;
  std::vector<int> moving_links_;
  std::vector<Attachment> attachments_;

  // A column for each pair of the world: how far its bodies move towards one another per unit of
  // each joint. Made again when the world's pairs or the attachments change.
  Eigen::MatrixXd motion_bounds_;
  int motion_revision_ = -1;
  std::vector<OpenPair> open_;  // a stack of stretches
};

}  // namespace graspless::scene
