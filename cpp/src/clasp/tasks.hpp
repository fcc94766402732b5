// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/linking.hpp"
#include "graspless/geometry/loops.hpp"

#include "clasp/kinematics.hpp"

namespace graspless::clasp {

/// x of the search: the centre of the curves' axis-aligned box, and the mean virtual linking.
using TaskPoint = Eigen::Vector4d;

/// The tasks of Section IV-E for one loop that stands still in the world, with their derivatives.
/// Not shared between threads.
class Tasks {
 public:
  using Matrix = Eigen::MatrixXd;

  /// Loop and targets in W.
  Tasks(const robot::Robot& robot, const Hand& hand, const Eigen::Matrix3Xd& p_WLoop,
        std::vector<geometry::ClaspTarget> targets_W);

  /// TS-PROJECTION. Everything below is at the configuration last given here.
  TaskPoint project(const Eigen::VectorXd& q);

  const HandKinematics& kinematics() const { return kinematics_; }
  const std::vector<geometry::ClaspTarget>& targets() const { return targets_W_; }

  Eigen::Vector3d position() const;                  ///< Pi_pos: p_AABB [m]
  Eigen::Vector2d alignment() const;                 ///< Pi_align, eq. (3), of the nearest target
  double linking() const;                            ///< Pi_vlink, eq. (4): mean of min(1, |VLk|)
  const Eigen::VectorXd& linking_of_curves() const;  ///< min(1, |VLk|), one a curve
  bool is_linked() const;                            ///< whether any curve is

  void position_jacobian(Matrix& J) const;   ///< 3 x dof
  void alignment_jacobian(Matrix& J) const;  ///< 2 x dof
  /// One row a linked curve (curves x dof, rows of curves that are not linked are zero).
  void linking_jacobian(Matrix& J) const;

 private:
  HandKinematics kinematics_;
  geometry::PreparedLoop loop_W_;
  std::vector<geometry::ClaspTarget> targets_W_;
};

}  // namespace graspless::clasp
