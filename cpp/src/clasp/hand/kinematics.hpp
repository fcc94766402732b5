// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "graspless/clasp/hand.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::clasp {

/// Positions and Jacobians of the finger curves. Not thread-safe.
class GRASPLESS_API HandKinematics {
 public:
  using Jacobian3 = Eigen::Matrix<double, 3, Eigen::Dynamic>;
  using Row = Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>>;

  HandKinematics(const robot::Robot& robot, const Hand& hand);

  /// Forward kinematics: computes the poses of all links and the nodes of all curves.
  void update(const Eigen::VectorXd& q);
  const robot::Poses& poses() const { return X_WL_; }

  /// All distinct nodes in W, 3 x n [m]: finger 0 from palm to tip, finger 1, ..., the thumb last.
  const Eigen::Matrix3Xd& nodes() const { return p_WN_; }
  int num_curves() const { return static_cast<int>(curves_.size()); }
  /// Curve i as indices into nodes(): from the tip of finger i to the tip of the thumb.
  const std::vector<int>& curve(int i) const { return curves_[i]; }
  Eigen::Matrix3Xd curve_points(int i) const;
  double longest_curve() const;        ///< its length [m]
  Eigen::Vector3d center_W() const;    ///< middle of the box around the nodes
  Eigen::Vector3d forward_W() const;   ///< v_fwd
  Eigen::Vector3d sideways_W() const;  ///< v_swd

  /// Adds the gradient of the dot product of `direction` and node n, at the configuration of the
  /// last update(), to a row (1 x dof).
  void add_row(int n, const Eigen::Vector3d& direction, Row row) const;
  /// Adds the product of `axis` and the hand frame's angular Jacobian to a row (1 x dof).
  void add_rotation_row(const Eigen::Vector3d& axis, Row row) const;

 private:
  /// A moving link with the joint that moves it.
  struct Mover {
    int link, joint;
    bool is_prismatic;
    Eigen::Vector3d axis_L;  // times the multiplier of a mimic joint
    Eigen::Vector3d axis_W, p_W;
  };
  struct Node {
    int link;
    Eigen::Vector3d p_L;
    std::vector<int> movers;  // indices in movers_ of the joints that move it
  };

  std::vector<int> movers_of(int link);
  int add_node(const CurveNode& node);
  std::vector<int> add_finger(const Finger& finger);

  robot::Robot robot_;
  robot::Poses X_WL_;
  std::vector<Mover> movers_;
  std::vector<Node> nodes_;
  Eigen::Matrix3Xd p_WN_;
  std::vector<std::vector<int>> curves_;
  int hand_frame_;
  std::vector<int> hand_movers_;
  Eigen::Vector3d forward_H_, sideways_H_;
};

}  // namespace graspless::clasp
