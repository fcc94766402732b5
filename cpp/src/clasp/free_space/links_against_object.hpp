// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The robot's links against the object that stands still.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/clasp/problem.hpp"
#include "graspless/collision/clearance.hpp"
#include "graspless/collision/world.hpp"

#include "clasp/free_space/link_spheres.hpp"

namespace graspless::clasp {

/// One link at a time, by spheres where these settle it and by FCL where not. Not shared between
/// threads.
class LinksAgainstObject {
 public:
  explicit LinksAgainstObject(const Problem& problem);

  /// Links that move against the object and have shapes.
  const std::vector<int>& links() const { return links_; }

  /// Whether a link touches, and if not a lower bound on its distance from the object [m] that is
  /// not made better than `enough`.
  struct Look {
    bool touches;
    double clearance;
  };
  Look look(int link, const Eigen::Isometry3d& X_WL, double enough);
  /// By FCL alone.
  bool touches_by_fcl(int link, const Eigen::Isometry3d& X_WL);

  std::int64_t num_fcl_checks() const { return fcl_checks_; }

 private:
  Eigen::Isometry3d X_OW_;
  std::vector<SphereTree> spheres_;
  collision::Clearance clearance_;
  collision::World world_;
  std::vector<int> links_;
  std::vector<int> body_;  // of a link, in world_; -1: none
  std::vector<int> pair_;  // of a link with the object
  std::int64_t fcl_checks_ = 0;
};

}  // namespace graspless::clasp
