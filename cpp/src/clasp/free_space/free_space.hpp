// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "graspless/clasp/problem.hpp"
#include "graspless/scene/scene.hpp"

#include "clasp/free_space/object_collision.hpp"

namespace graspless::clasp {

/// Collision-free configurations and motions of the robot, including joint limits and
/// self-collision. Spheres around the links and the object's clearance decide clear cases. FCL with
/// the triangles of the object decides the others. They are a surface, so a link wholly inside does
/// not touch it, but no motion checked in small steps leads there. Not thread-safe.
class GRASPLESS_API FreeSpace {
 public:
  explicit FreeSpace(const Problem& problem);

  /// True if configuration q is free.
  bool is_free(const Eigen::VectorXd& q);
  /// True if is_free(q) holds at both ends of the straight motion and at even steps of at most
  /// `resolution` [rad or m] in any joint. Parts that bounds on the motion prove free are not
  /// sampled.
  bool is_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double resolution);
  /// Names of the first colliding pair at q; empty if free.
  std::pair<std::string, std::string> collision(const Eigen::VectorXd& q);

  std::int64_t num_checks() const { return checks_; }  ///< configurations checked
  /// Number of tests of a link against the object by FCL.
  std::int64_t num_fcl_checks() const { return object_.num_fcl_checks(); }

 private:
  void update_poses(const Eigen::VectorXd& q);
  bool misses_object();
  bool find_uncertain_links(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, int steps,
                            std::vector<scene::OpenPair>& links);

  robot::Robot robot_;
  std::string object_name_;
  scene::Scene scene_;  // everything except the object
  ObjectCollision object_;
  std::vector<int> links_;  // moving links with shapes
  bool base_touches_object_ = false;
  robot::Poses X_WL_;
  std::int64_t checks_ = 0;
};

}  // namespace graspless::clasp
