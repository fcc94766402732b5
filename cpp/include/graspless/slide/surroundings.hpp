// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surroundings of a robot that follows a slide, which it must not touch. A plan is free of
// collisions; a motion that deviates from it, because the object does, has to be tested again.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"
#include "graspless/slide/options.hpp"
#include "graspless/slide/problem.hpp"

namespace graspless::slide {

/// The support and the obstacles around robot and object, and the robot's own links. Contacts
/// between robot and object are not looked at: the hand is moved to where the object is. Not
/// thread-safe.
class GRASPLESS_API Surroundings {
 public:
  /// Copies what it needs of the problem. The finger may press on the support as deep as in a plan
  /// with these options. Throws std::invalid_argument that names the field of a bad problem.
  explicit Surroundings(const Problem& problem, const Options& options = {});
  ~Surroundings();
  Surroundings(Surroundings&&) noexcept;
  Surroundings& operator=(Surroundings&&) noexcept;

  const Problem& problem() const;

  /// Returns the names of touching pairs, "a - b", with the robot at q and the object at X_WO.
  ///
  /// Links that the arm moves relative to each other count as touching up to a distance of 0.5 mm;
  /// plans keep 2 mm. Pairs that are nearer at home, or built close to each other, count only if
  /// they touch. `segment` of a plan decides which contacts are allowed. The support is `rise`
  /// higher than in the problem [m]. Joint limits are not checked. Throws std::invalid_argument if
  /// q is of the wrong size or not finite, X_WO is not a rigid pose, or there is no such segment.
  std::vector<std::string> touching(const std::string& segment, const Eigen::VectorXd& q,
                                    const Eigen::Isometry3d& X_WO, double rise = 0);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graspless::slide
