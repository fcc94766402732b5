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

/// A ball around some balls that are neighbours.
struct BallGroup {
  Eigen::Index begin, end;  ///< of its balls
  Eigen::Vector3d middle;
  double radius;  ///< of a ball about the middle that has all centres [m]
  double around;  ///< of one that has all balls [m]
};

/// Sorts the part of `order` from begin to end, indices of points, into compact groups of at most
/// `most` and adds them. Their balls have no radius yet.
void group_neighbours(const Eigen::Matrix3Xd& points, std::vector<int>& order, Eigen::Index begin,
                      Eigen::Index end, Eigen::Index most, std::vector<BallGroup>& groups);

/// Sorts balls into compact groups. Centres and radii in [m].
std::vector<BallGroup> sort_into_groups(Eigen::Matrix3Xd& centers, Eigen::VectorXd& radii);

}  // namespace graspless::clasp
