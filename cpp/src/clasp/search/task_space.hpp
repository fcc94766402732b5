// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/linking.hpp"
#include "graspless/geometry/loops.hpp"

#include "clasp/hand/kinematics.hpp"

namespace graspless::clasp {

/// Point of the task space X: p_AABB, the centre of the curves' bounding box, and Pi_vlink, eq.
/// (4).
using TaskPoint = Eigen::Vector4d;

/// Task-space projections of Stork 2013, Section IV-E, with their Jacobians, for one loop at rest.
/// Not thread-safe.
class TaskSpace {
 public:
  using Matrix = Eigen::MatrixXd;

  /// `p_WLoop`: corners of the loop, 3 x n in W [m].
  TaskSpace(const robot::Robot& robot, const Hand& hand, const Eigen::Matrix3Xd& p_WLoop,
            std::vector<geometry::ClaspTarget> targets_W);

  /// TS-PROJECTION. All functions below refer to the configuration last projected. Returns at once
  /// if q is that configuration. Allocates no memory.
  const TaskPoint& project(const Eigen::VectorXd& q);

  const HandKinematics& kinematics() const { return kinematics_; }
  const std::vector<geometry::ClaspTarget>& targets() const { return targets_W_; }

  Eigen::Vector3d position() const { return x_.head<3>(); }  ///< Pi_pos: p_AABB [m]
  /// Pi_align, eq. (3), for the nearest target; (., 1) if the centre lies on the target.
  Eigen::Vector2d alignment() const;
  double linking() const { return x_[3]; }  ///< Pi_vlink, eq. (4): mean of min(1, |VLk|)
  /// min(1, |VLk|) of every curve, eq. (2).
  const Eigen::VectorXd& linking_of_curves() const { return linking_; }
  int nearest_target() const { return nearest_; }
  double target_distance() const {
    return distance_;
  }  ///< from the centre to the nearest target [m]

  /// Jacobians. Where the corners that bound the box or the nearest target change, they are those
  /// of the current ones.
  void position_jacobian(Matrix& J) const;   ///< 3 x dof
  void alignment_jacobian(Matrix& J) const;  ///< 2 x dof; the second row is 0 on the target
  /// curves x dof. The linking number is piecewise constant, so rows of curves that are not linked
  /// are zero.
  void linking_jacobian(Matrix& J) const;
  /// For curves that are not linked, uses the Gauss integral of the open curve instead of the
  /// virtual linking: replaces their entries of u by 1 - |integral| and their rows of J by its
  /// gradient.
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

  Eigen::VectorXd q_;  // configuration of everything below
  TaskPoint x_;
  Eigen::Vector3i lowest_, highest_;  // nodes that bound the box
  int nearest_ = 0;
  double distance_ = 0;
  Eigen::Vector3d towards_;  // t_near; zero on the target
  std::vector<Curve> curves_;
  Eigen::VectorXd linking_;
};

}  // namespace graspless::clasp
