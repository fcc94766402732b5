// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "robot/wraps.hpp"

namespace graspless::robot {

/// An axis of rotation: all points p + t * axis.
struct Screw {
  Eigen::Vector3d axis;  // unit
  Eigen::Vector3d point;
};

/// Inverse kinematics of seven revolute joints whose axes 1 to 3 meet in the shoulder and whose
/// axes 5 to 7 meet in the wrist.
///
/// For a given angle q3, Paden and Kahan's subproblems (Murray, Li and Sastry, A Mathematical
/// Introduction to Robotic Manipulation, 1994, Section 3.3) give at most eight solutions: the
/// distance from shoulder to wrist gives q4 (subproblem 3), the wrist's position gives q1 and q2
/// (subproblem 2), the hand's direction gives q5 and q6 (subproblem 2), and its remaining rotation
/// gives q7 (subproblem 1). The elbow may be offset.
class ClosedForm {
 public:
  /// Creates a solver from the seven axes and the pose of the last link at q = 0, in the frame P
  /// that carries the first joint. Returns nothing if the axes do not meet within 1e-9 m, or if two
  /// axes are parallel that must not be.
  static std::optional<ClosedForm> detect(const std::array<Screw, 7>& screws,
                                          const Eigen::Isometry3d& X_P7);

  /// Appends configurations of all joints, as Wraps::append() does. `q` gives the angles that a
  /// solution leaves arbitrary.
  int solve(const Eigen::Isometry3d& X_P7, double q3, const Eigen::VectorXd& q, const Wraps& wraps,
            int count, Eigen::MatrixXd& solutions) const;

 private:
  struct Turn;
  struct Search;
  struct TwoTurns;

  /// Geometry of axis 4 at q = 0: |shoulder to wrist|^2 = sum - product cos(q4 - angle).
  struct Elbow {
    static Elbow of(const Screw& screw, const Eigen::Vector3d& shoulder,
                    const Eigen::Vector3d& wrist);

    Eigen::Vector3d p_SE, p_EW;  // shoulder to elbow, elbow to wrist
    double sum, product;         // [m^2]
    double angle, c, s;          // q4 at which wrist and shoulder are nearest, its cosine and sine
  };

  std::array<Eigen::Vector3d, 7> axis_;
  Eigen::Vector3d shoulder_, wrist_;  // points in P at q = 0
  Elbow elbow_;
  Eigen::Matrix3d R_7P_;    // at q = 0
  Eigen::Vector3d p_7W_;    // the wrist, fixed in link 7
  Eigen::Vector3d across_;  // unit, perpendicular to axis 7
};

}  // namespace graspless::robot
