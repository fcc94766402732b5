// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "robot/polish.hpp"
#include "robot/subproblems.hpp"
#include "robot/wraps.hpp"

namespace graspless::robot {

/// Inverse kinematics of six or seven revolute joints in closed form. Three shapes of six joints
/// have one, from base to hand or from hand to base:
///
/// - a wrist of three axes that meet, and a shoulder of two axes that meet;
/// - a wrist of three axes that meet, and parallel axes 2 and 3;
/// - parallel axes 2, 3 and 4, and axes 5 and 6 that meet.
///
/// A seventh joint is free: its angle is given, and the other six have one of these shapes. It is
/// the third joint where axes 1 to 3 and axes 5 to 7 meet, otherwise the last or the first. For
/// each angle of the free joint there are at most eight solutions. An arm that has a shape but for
/// small offsets gets the solutions of that shape, polished by Newton's method.
class ClosedForm {
 public:
  /// Creates a solver from the axes of six or seven joints and the pose of the last link at q = 0,
  /// in the frame P that carries the first joint. Returns nothing for arms of another shape.
  static std::optional<ClosedForm> detect(const std::vector<Screw>& screws,
                                          const Eigen::Isometry3d& X_PE);

  /// Index of the joint whose angle solve() takes; -1 for six joints.
  int free_joint() const { return polish_.held; }

  /// Appends configurations of all joints, as Wraps::append() does. `q` gives the angles that a
  /// solution leaves arbitrary.
  int solve(const Eigen::Isometry3d& X_PE, double free_angle, const Eigen::VectorXd& q,
            const Wraps& wraps, int count, Eigen::MatrixXd& solutions) const;

 private:
  enum class Shape { shoulder_meets, elbow_parallel, three_parallel };
  enum class Free { none, first, third, last };
  using Axes = std::array<Screw, 6>;
  struct Search;

  ClosedForm(const std::vector<Screw>& screws, const Eigen::Isometry3d& X_PE, Shape shape,
             Free free, bool reversed);
  Axes ordered() const;
  bool fit(Axes axes);
  bool meet(std::initializer_list<const Screw*> axes, Eigen::Vector3d& point);
  bool make_parallel(int last, Axes& axes);
  Eigen::Isometry3d target_of_six(const Eigen::Isometry3d& X_PE, double free_angle) const;

  Polish polish_;  // has the true axes
  Shape shape_;
  Free free_;
  bool reversed_;         // joint 1 of the shape is the hand's
  double deviation_ = 0;  // of the true axes from the shape [m, rad]
  double slack_ = kRounding;

  std::array<int, 6> joint_{};           // the joints in the order of the shape
  std::array<Eigen::Vector3d, 6> axis_;  // theirs in the shape
  Screw free_axis_;                      // in the last link if that is free, otherwise in P
  Eigen::Vector3d base_;                 // a point of axis 1
  Eigen::Vector3d shoulder_;             // where axes 1 and 2 meet, or a point of axis 2
  Eigen::Vector3d wrist_;                // where the last two or three axes meet
  Eigen::Vector3d p_W4_;                 // from the wrist to axis 4, if 2, 3 and 4 are parallel
  Elbow elbow_;                          // axis 3
  Eigen::Matrix3d R_EP_;                 // at q = 0
  Eigen::Vector3d p_EW_;                 // the wrist, fixed in the last link
  Eigen::Vector3d across_;               // unit, perpendicular to axis 6
};

}  // namespace graspless::robot
