// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/linking.hpp"
#include "graspless/geometry/loops.hpp"

#include "clasp/hand/kinematics.hpp"

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

  /// TS-PROJECTION. Everything below is at the configuration last given here. Asked again about the
  /// same one it has nothing to do. Allocates nothing.
  const TaskPoint& project(const Eigen::VectorXd& q);

  const HandKinematics& kinematics() const { return kinematics_; }
  const std::vector<geometry::ClaspTarget>& targets() const { return targets_W_; }

  Eigen::Vector3d position() const { return x_.head<3>(); }  ///< Pi_pos: p_AABB [m]
  /// Pi_align, eq. (3), of the nearest target; (., 1) when the centre lies on the target.
  Eigen::Vector2d alignment() const;
  double linking() const { return x_[3]; }  ///< Pi_vlink, eq. (4): mean of min(1, |VLk|)
  /// min(1, |VLk|), one a curve.
  const Eigen::VectorXd& linking_of_curves() const { return linking_; }
  bool is_linked() const;  ///< whether any curve is
  int nearest_target() const { return nearest_; }
  double target_distance() const { return distance_; }  ///< of the centre to that [m]

  /// Derivatives by q. Where another corner comes to bound the box, or another target to be the
  /// nearest, they are those of the ones that count now.
  void position_jacobian(Matrix& J) const;   ///< 3 x dof
  void alignment_jacobian(Matrix& J) const;  ///< 2 x dof; the second row 0 on the target
  /// curves x dof; the linking number is constant but where curves cross, so that rows of curves
  /// that are not linked are zero.
  void linking_jacobian(Matrix& J) const;
  /// For curves that are not linked, the open curve's Gauss integral in place of the virtual
  /// linking: replaces their entries of u by 1 - |integral|, their rows of J by its derivative.
  void attract(Eigen::VectorXd& u, Matrix& J) const;

 private:
  struct Curve {
    Eigen::Matrix3Xd points, gradient;  // of its closedness
    int linking_number = 0;
    double closedness = 0;
  };

  void find_center();
  void find_target();
  void link(Curve& curve, const std::vector<int>& corners);

  HandKinematics kinematics_;
  geometry::PreparedLoop loop_W_;
  std::vector<geometry::ClaspTarget> targets_W_;

  Eigen::VectorXd q_;  // of everything below
  TaskPoint x_;
  Eigen::Vector3i lowest_, highest_;  // nodes that bound the box
  int nearest_ = 0;
  double distance_ = 0;
  Eigen::Vector3d towards_;  // t_near; zero on the target
  std::vector<Curve> curves_;
  Eigen::VectorXd linking_;
};

}  // namespace graspless::clasp
