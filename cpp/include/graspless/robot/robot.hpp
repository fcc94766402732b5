// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::robot {

/// Poses of all frames in the world, indexed as Robot::frame_names().
using Poses = std::vector<Eigen::Isometry3d>;

/// A collision shape of a link.
struct LinkShape {
  int link;  ///< frame index
  geometry::PlacedShape placed;
};

/// A rigid-body tree read from a URDF: what moves, how far, and what it looks like to a collision
/// checker.
///
/// A configuration q holds the values of the independent joints [rad or m] in the URDF's tree
/// order: depth first, the joints of one link in the order of the file. A mimic joint follows its
/// own, through other mimics too; its own limits are not looked at. Every link is a frame, in the
/// same order, the root first. Immutable; copies share their data, and const calls may run in
/// parallel.
class GRASPLESS_API Robot {
 public:
  struct Options {
    std::string srdf;  ///< SRDF text; groups and disable_collisions are taken from it
    std::map<std::string, std::string> packages;  ///< where package://NAME/ points
    std::string directory;                        ///< what relative mesh paths are relative to
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< pose of the root link in the world
  };

  /// Reads URDF text. Throws std::invalid_argument naming the element at fault: XML that does not
  /// parse, a cycle or several roots, a planar or floating joint, a revolute or prismatic one
  /// without limits, a mimic joint of an unknown one, a mesh that cannot be read, a collision shape
  /// that is not finite and positive.
  static Robot from_urdf(const std::string& xml, const Options& options);
  /// Reads a .urdf file; a .srdf of the same name beside it is read too unless `options.srdf` is
  /// given.
  static Robot from_urdf_file(const std::string& path, Options options);
  static Robot from_urdf_file(const std::string& path);

  const std::string& name() const;
  int dof() const;  ///< number of independent joints
  const std::vector<std::string>& joint_names() const;
  const Eigen::VectorXd& lower() const;  ///< [rad or m]; a continuous joint has -pi
  const Eigen::VectorXd& upper() const;  ///< [rad or m]; a continuous joint has pi
  const Eigen::VectorXd& max_velocity()
      const;                                  ///< [rad/s or m/s]; infinity where the URDF has none
  const Eigen::VectorXd& max_effort() const;  ///< [Nm or N]
  const Eigen::Isometry3d& X_WB() const;

  const std::vector<std::string>& frame_names() const;
  /// Index of a link's frame. Throws std::invalid_argument that lists the links.
  int frame(const std::string& link) const;
  int parent(int frame) const;  ///< frame index of the parent link; -1 for the root
  /// Index of an independent joint. Throws std::invalid_argument that lists the joints.
  int joint(const std::string& name) const;
  /// Joint indices of a group of the SRDF. Throws std::invalid_argument that lists the groups.
  const std::vector<int>& group(const std::string& name) const;
  std::vector<std::string> group_names() const;
  /// The group's configuration of that name in the SRDF (group_state), as a whole q; joints it
  /// does not name are 0 clamped to their limits. States of one name and several groups are one.
  /// Throws std::invalid_argument that lists the states.
  const Eigen::VectorXd& state(const std::string& name) const;
  std::vector<std::string> state_names() const;

  /// The poses of all frames, in one pass through the tree. `X_WL` is resized once.
  void forward(const Eigen::VectorXd& q, Poses& X_WL) const;
  /// As forward(), only for the frames from the root to `frame`; the others are left as they were.
  void forward_to(int frame, const Eigen::VectorXd& q, Poses& X_WL) const;
  Eigen::Isometry3d pose(int frame, const Eigen::VectorXd& q) const;

  /// The 6 x dof Jacobian of a frame's origin in the world, linear rows first, from poses that
  /// forward() or forward_to() gave at q.
  void jacobian(int frame, const Poses& X_WL, Eigen::Matrix<double, 6, Eigen::Dynamic>& J) const;
  Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(int frame, const Eigen::VectorXd& q) const;

  /// Clamps to the limits; is_within() allows a slack of `tolerance` [rad or m].
  Eigen::VectorXd clamp(const Eigen::VectorXd& q) const;
  bool is_within(const Eigen::VectorXd& q, double tolerance = 1e-9) const;

  const std::vector<LinkShape>& shapes() const;
  /// Pairs of links (smaller index first) that are never tested: joined by a joint (through links
  /// without shapes, fixed joints and all), rigidly connected, or disabled in the SRDF.
  const std::set<std::pair<int, int>>& ignored_pairs() const;

  /// An upper bound on how far any point of any shape of `link` moves, per unit of each joint
  /// [m/rad or 1], over all configurations within the limits: the lever arms of conservative motion
  /// checking. Size dof. A link without shapes counts as its origin.
  const Eigen::VectorXd& reach(int link) const;

  struct Model;  // the KDL tree and the tables made from it; not part of the interface
  const Model& model() const { return *model_; }
  /// Equal for copies, unequal for robots read apart; expires with the last copy.
  std::weak_ptr<const void> identity() const { return model_; }

 private:
  explicit Robot(std::shared_ptr<const Model> model) : model_(std::move(model)) {}
  std::shared_ptr<const Model> model_;
};

/// Throws std::invalid_argument, naming `field`, unless q has a value for every joint, within its
/// limits.
GRASPLESS_API void require_configuration(const Robot& robot, const Eigen::VectorXd& q,
                                         const std::string& field);

}  // namespace graspless::robot
