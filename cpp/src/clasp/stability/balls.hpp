// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/robot/robot.hpp"

#include "clasp/free_space/link_spheres.hpp"

namespace graspless::clasp {

/// Balls inside the links that fill them up to edges and dents of about a millimetre.
class LinkBalls {
 public:
  explicit LinkBalls(const robot::Robot& robot, MeshInside inside = MeshInside::hull);

  Eigen::Matrix3Xd centers_W(const robot::Poses& X_WL) const;  ///< centres, 3 x n [m]
  const Eigen::VectorXd& radii() const { return radii_; }      ///< [m]
  const std::vector<int>& links() const { return links_; }     ///< link of each ball

 private:
  std::vector<int> links_;
  Eigen::Matrix3Xd p_L_;
  Eigen::VectorXd radii_;
};

}  // namespace graspless::clasp
