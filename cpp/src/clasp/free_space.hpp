// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "graspless/clasp/problem.hpp"
#include "graspless/collision/clearance.hpp"
#include "graspless/scene/scene.hpp"

namespace graspless::clasp {

/// Where robot, object and obstacles do not touch. FCL against the triangles of K_d is the judge;
/// spheres around the links and the object's clearance settle the clear cases before it. Limits and
/// self-collision included. Not shared between threads.
class FreeSpace {
 public:
  explicit FreeSpace(const Problem& problem);

  bool is_free(const Eigen::VectorXd& q);
  /// Whether the straight motion is: what is_free(q) says at its ends and at even steps of at most
  /// `resolution` in any joint; stretches that bounds on the motion prove free are not stepped
  /// through.
  bool is_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double resolution);
  /// The first touching pair at q, by name, by FCL; empty names when free.
  std::pair<std::string, std::string> collision(const Eigen::VectorXd& q);

  std::int64_t num_checks() const;      ///< configurations looked at
  std::int64_t num_fcl_checks() const;  ///< links tested against the object by FCL

 private:
  // owned by the implementer of this file
};

}  // namespace graspless::clasp
