// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/robot/robot.hpp"

namespace graspless::clasp {

/// Balls within the links that fill them but for edges and dents of a millimetre.
class LinkBalls {
 public:
  explicit LinkBalls(const robot::Robot& robot);

  Eigen::Matrix3Xd centers_W(const robot::Poses& X_WL) const;  ///< one a column [m]
  const Eigen::VectorXd& radii() const { return radii_; }      ///< [m]

 private:
  std::vector<int> links_;
  Eigen::Matrix3Xd p_L_;
  Eigen::VectorXd radii_;
};

}  // namespace graspless::clasp
