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

/// A rigid-body tree read from a URDF: its kinematics, joint limits and collision shapes.
///
/// A configuration q holds the values of the independent joints [rad or m] in the URDF's tree
/// order: depth first, the joints of one link in the order of the file. A mimic joint follows the
/// joint that it mimics, directly or through other mimic joints; its own limits are ignored. Every
/// link is a frame, in the same order, the root first. Immutable. Copies share their data, and
/// const calls may run in parallel.
class GRASPLESS_API Robot {
 public:
  /// A copy shares all data. Moving copies, so that no object is left empty.
  Robot(const Robot&) = default;
  Robot& operator=(const Robot&) = default;

  struct Options {
    std::string srdf;  ///< SRDF text: groups, group states and disabled collisions
    std::map<std::string, std::string> packages;  ///< directory of each package://NAME/
    std::string directory;                        ///< directory that relative mesh paths start from
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< pose of the root link in the world
  };

  /// Reads URDF text. Throws std::invalid_argument that names the faulty element: XML that does not
  /// parse, a cycle or several roots, a planar or floating joint other than at the root, a
  /// revolute or prismatic joint without limits, a mimic joint of an unknown joint, a mesh that
  /// cannot be read, or a collision shape whose size is not finite and positive.
  static Robot from_urdf(const std::string& xml, const Options& options);
  /// Reads a .urdf file. Unless `options.srdf` is given, also reads a .srdf file of the same name
  /// in the same directory. Packages that `options` does not have are looked for: find_packages().
  static Robot from_urdf_file(const std::string& path, Options options);
  static Robot from_urdf_file(const std::string& path);

  const std::string& name() const;
  const std::string& urdf() const;  ///< text that the robot was read from
  const Options& options() const;   ///< SRDF, packages, folder and pose that it was read with
  int dof() const;                  ///< number of independent joints
  const std::vector<std::string>& joint_names() const;
  const Eigen::VectorXd& lower() const;         ///< [rad or m]; a continuous joint has -pi
  const Eigen::VectorXd& upper() const;         ///< [rad or m]; a continuous joint has pi
  const Eigen::VectorXd& max_velocity() const;  ///< [rad/s or m/s]; infinite if it has none, or 0
  const Eigen::VectorXd& max_effort() const;    ///< [Nm or N]; infinite if it has none, or 0
  const Eigen::Isometry3d& X_WB() const;

  const std::vector<std::string>& frame_names() const;
  /// Index of a link's frame. Throws std::invalid_argument that lists the links.
  int frame(const std::string& link) const;
  int parent(int frame) const;  ///< frame index of the parent link; -1 for the root
  /// Index of an independent joint. Throws std::invalid_argument that lists the joints.
  int joint(const std::string& name) const;
  /// Parts of the URDF and SRDF that were ignored or changed, one sentence each: for instance
  /// links without a collision shape, or an entry of the SRDF that names an unknown link.
  const std::vector<std::string>& warnings() const;
  /// Joint indices of a group of the SRDF. Throws std::invalid_argument that lists the groups, or
  /// says what is wrong with this one.
  const std::vector<int>& group(const std::string& name) const;
  std::vector<std::string> group_names() const;
  /// Configuration of all joints in a group state of the SRDF. Joints that it does not name are
  /// 0, clamped to their limits. States of the same name in several groups are merged. Throws
  /// std::invalid_argument that lists the states, or says what is wrong with this one.
  const Eigen::VectorXd& state(const std::string& name) const;
  /// Same, but joints that the state does not name are as in `others`.
  Eigen::VectorXd state(const std::string& name, const Eigen::VectorXd& others) const;
  std::vector<std::string> state_names() const;

  /// Computes the poses of all frames at q in one pass through the tree. Resizes `X_WL` if needed.
  void forward(const Eigen::VectorXd& q, Poses& X_WL) const;
  /// Same, but only for the frames from the root to `frame`; the others keep their values.
  void forward_to(int frame, const Eigen::VectorXd& q, Poses& X_WL) const;
  Eigen::Isometry3d pose(int frame, const Eigen::VectorXd& q) const;

  /// Computes the 6 x dof Jacobian of a frame's origin in W, linear rows first, from the poses that
  /// forward() or forward_to() computed at q.
  void jacobian(int frame, const Poses& X_WL, Eigen::Matrix<double, 6, Eigen::Dynamic>& J) const;
  Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(int frame, const Eigen::VectorXd& q) const;

  /// Factor of each joint in the length of a step: 1 for a revolute joint, 10 rad/m for a prismatic
  /// one. Steps between rows and between checked configurations are limited in these units, so that
  /// 0.01 rad correspond to 1 mm.
  const Eigen::VectorXd& step_weights() const;
  /// Largest step of a joint between two configurations, in the units of step_weights() [rad].
  double step(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2) const;

  /// Returns q clamped to the joint limits.
  Eigen::VectorXd clamp(const Eigen::VectorXd& q) const;
  /// True if q is within the joint limits, up to `tolerance` [rad or m].
  bool is_within(const Eigen::VectorXd& q, double tolerance = 1e-9) const;

  const std::vector<LinkShape>& shapes() const;
  /// Pairs of links (smaller index first) that are never tested for collision: adjacent (also
  /// across links without shapes), rigidly connected, or disabled in the SRDF.
  const std::set<std::pair<int, int>>& ignored_pairs() const;

  /// Upper bound on how far any point of the shapes of `link` moves per unit of each joint [m/rad
  /// or 1], over all configurations within the limits; size dof. Used for conservative motion
  /// checking. For a link without shapes: its origin.
  const Eigen::VectorXd& reach(int link) const;

  struct Model;  // links, and tables made from them; not part of the interface
  const Model& model() const { return *model_; }
  /// Identity shared by all copies of one robot; expires with the last copy.
  std::weak_ptr<const void> identity() const { return model_; }

 private:
  explicit Robot(std::shared_ptr<const Model> model) : model_(std::move(model)) {}
  std::shared_ptr<const Model> model_;
};

/// Throws std::invalid_argument that names `field` unless q has a value for every joint within its
/// limits.
GRASPLESS_API void require_configuration(const Robot& robot, const Eigen::VectorXd& q,
                                         const std::string& field);

/// True if q has a finite value for every joint, for sliding joints of at most 1000 m, whatever the
/// limits.
GRASPLESS_API bool is_configuration(const Robot& robot, const Eigen::VectorXd& q);

}  // namespace graspless::robot
