// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A hand that does not move, as balls in the frame of the object.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/clasp/problem.hpp"

namespace graspless::clasp {

class Core;

/// Closed chain of balls around a curve, such that the curve needs to come as near as possible to
/// pass between two of them.
struct HandRing {
  Eigen::Matrix3Xd points_O;   // centres of its balls, in order [m]; none: there is no ring
  double clearance = 0;        // at most this is left where the curve passes [m]
  double gap = 0;              // between the two balls where it passes [m]
  std::array<int, 2> balls{};  // these two
};

struct StillHand {
  StillHand(const Problem& problem, const Eigen::VectorXd& q);

  /// Balls near the curves of the fingers that are not inside the object.
  std::vector<int> balls_outside(const Core& core) const;
  /// Ring of some of the balls that is linked with a closed curve, 3 x n in O, along which a ball
  /// of `radius` fits into the object.
  HandRing ring(const Eigen::Matrix3Xd& curve_O, double radius, const std::vector<int>& near) const;

  Eigen::Matrix3Xd p_OB;   ///< centres of the balls at the clasp, 3 x n in O [m]
  Eigen::VectorXd radii;   ///< [m]
  std::vector<int> links;  ///< link of each ball
  Eigen::Vector3d p_OC;    ///< centre of the box of the finger curves [m]
  double reach = 0;        ///< radius of a ball about C that contains the curves and rings [m]
};

}  // namespace graspless::clasp
