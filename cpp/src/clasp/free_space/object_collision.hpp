// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Collision of the robot's links with the object, which does not move.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/clasp/problem.hpp"
#include "graspless/collision/clearance.hpp"
#include "graspless/collision/world.hpp"

#include "clasp/free_space/link_spheres.hpp"

namespace graspless::clasp {

/// Lower bound on the distance of a link from a surface, by its spheres [m]; 0 if they do not prove
/// it apart. Not more than `enough`.
double distance_by_spheres(const SphereTree& tree, const Eigen::Isometry3d& X_OL, double enough,
                           collision::Clearance& clearance);

/// Checks one link at a time: by bounding spheres if these decide, else by FCL. Not thread-safe.
class ObjectCollision {
 public:
  explicit ObjectCollision(const Problem& problem);

  /// Links with shapes.
  const std::vector<int>& links() const { return links_; }

  /// Result of a check: a touch, or a lower bound on the distance to the object [m].
  struct Result {
    bool touches;
    double clearance;
  };
  /// Checks a link at pose X_WL. The bound is not refined beyond `enough` [m].
  Result check(int link, const Eigen::Isometry3d& X_WL, double enough);
  /// Same by FCL alone.
  bool touches_by_fcl(int link, const Eigen::Isometry3d& X_WL);

  std::int64_t num_fcl_checks() const { return fcl_checks_; }

 private:
  Eigen::Isometry3d X_OW_;
  std::vector<SphereTree> spheres_;
  collision::Clearance clearance_;
  collision::World world_;
  std::vector<int> links_;
  std::vector<int> body_;  // per link: body in world_, or -1
  std::vector<int> pair_;  // per link: pair with the object in world_, or -1
  std::int64_t fcl_checks_ = 0;
};

}  // namespace graspless::clasp
