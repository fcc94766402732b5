// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/world.hpp"
#include "graspless/export.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::scene {

struct OpenPair;

/// A robot among obstacles and objects. Each link with a shape is a body of the world and carries
/// the link's name. Links are tested against each other (except Robot::ignored_pairs) and against
/// every obstacle and object. Obstacles and objects are tested against each other only after
/// world().add_pair(). Use world().allow_contact() for contact allowances. Not thread-safe: give
/// each thread a copy, which costs microseconds.
class GRASPLESS_API Scene {
 public:
  explicit Scene(const robot::Robot& robot);

  const robot::Robot& robot() const { return robot_; }
  collision::World& world() { return world_; }
  const collision::World& world() const { return world_; }

  /// Adds a fixed body that no link may touch. With `touches_base`, the root link and links rigid
  /// with it may. Returns the body's index in the world.
  int add_obstacle(const std::string& name, const std::vector<geometry::PlacedShape>& shapes,
                   const Eigen::Isometry3d& X_WB, bool touches_base = true);
  int add_obstacle(const std::string& name, const collision::Solid& solid,
                   const Eigen::Isometry3d& X_WB, bool touches_base = true);
  /// Adds a movable body (see move_object, attach) that no link may touch.
  int add_object(const std::string& name, const std::vector<geometry::PlacedShape>& shapes);
  int add_object(const std::string& name, const collision::Solid& solid);
  void move_object(int body, const Eigen::Isometry3d& X_WO);
  /// Lets the body move with `link` until move_object() or detach(), which leave it where it is.
  /// Links in `touching` may touch it meanwhile. Throws std::invalid_argument if the body is a link
  /// or there is no such link.
  void attach(int body, int link, const Eigen::Isometry3d& X_LO, const std::vector<int>& touching);
  void detach(int body);

  /// Lets links that `joints` move relative to each other count as touching unless they are proven
  /// to be more than `clearance` [m] apart. Two kinds of pairs need only not touch: those that are
  /// nearer in one of the configurations `given`, and those that are built close to each other,
  /// that is within 2 mm, or not proven apart, without touching, where all `joints` are at a
  /// quarter, at half and at three quarters of their ranges. Replaces the demand of an earlier
  /// call.
  void keep_links_apart(double clearance, const std::vector<int>& joints,
                        const std::vector<Eigen::VectorXd>& given);

  /// Index in the world of a link's body; -1 for a link without shapes.
  int link_body(int link) const { return link_body_.at(static_cast<std::size_t>(link)); }

  /// True if q is within the joint limits and nothing touches.
  bool is_free(const Eigen::VectorXd& q);
  /// Same, from poses already computed. Joint limits are not checked.
  bool is_free(const robot::Poses& X_WL);
  /// True if q1 and q2 are within the limits and the straight motion between them is free:
  /// is_free(q) holds at both ends and at equal steps whose Robot::step() is `resolution` [rad] at
  /// most. Skips stretches that a bound on the motion of every pair (Robot::reach) proves free.
  bool is_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double resolution = 0.01);
  /// Returns the names of the first pair that touches at q; empty if none does. Joint limits are
  /// not checked.
  std::pair<std::string, std::string> collision(const Eigen::VectorXd& q);
  /// Same as is_free(X_WL), but returns the indices in the world of the first pair that touches.
  std::optional<std::pair<int, int>> first_collision(const robot::Poses& X_WL);

  /// Link poses at the configuration checked last by is_free(q) or collision(q).
  const robot::Poses& poses() const { return X_WL_; }

 private:
  struct Attachment {
    int body, link;
    Eigen::Isometry3d X_LO;
    std::vector<std::pair<int, int>> suspended;  // pairs that are not tested while attached
  };

  std::vector<int> built_close(std::vector<int> pairs, const std::vector<int>& joints,
                               const std::vector<Eigen::VectorXd>& given);
  void keep_apart(int pair, double clearance);
  void place(const robot::Poses& X_WL);
  void place(const Eigen::VectorXd& q);
  void update_motion_bounds();
  bool open_pairs(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, int steps,
                  std::vector<OpenPair>& open);

  robot::Robot robot_;
  collision::World world_;
  robot::Poses X_WL_;
  std::vector<int> link_body_;
  std::vector<int> moving_links_;
  std::vector<Attachment> attachments_;

  // One column per pair of the world: how far its bodies approach each other per unit of each
  // joint. Recomputed when the world's pairs or the attachments change.
  Eigen::MatrixXd motion_bounds_;
  int motion_revision_ = -1;
};

}  // namespace graspless::scene
