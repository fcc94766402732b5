// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Objects and problems that the tests of free space, closing and stability share.
#pragma once

#include <random>
#include <string>

#include "graspless/clasp/problem.hpp"
#include "graspless/clasp/sample_objects.hpp"
#include "graspless/geometry/sampling.hpp"

#include "clasp/hands.hpp"

namespace graspless::clasp {

/// A ring in the plane z = 0 about the origin, `thick` in diameter.
inline Object ring(double radius, double thick, int along = 60, int around = 8) {
  Eigen::Matrix3Xd points(3, along * around);
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      const double a = 2 * M_PI * i / along, b = 2 * M_PI * (j + 0.5 * (i % 2)) / around;
      const double r = radius + thick / 2 * std::cos(b);
      points.col(i * around + j) << r * std::cos(a), r * std::sin(a), thick / 2 * std::sin(b);
    }
  }
  geometry::LoopOptions options;
  options.max_edge_length = std::max(4 * M_PI * radius / along, 1.2 * thick);
  return Object::from_cloud("ring", points, options);
}

/// One of our sample objects, K_d as fine as 2000 points allow.
inline Object sample(const std::string& name, double max_edge_length = 0.04) {
  geometry::LoopOptions options;
  options.max_edge_length = max_edge_length;
  return Object::from_cloud(name, geometry::sample_surface(sample_object(name), 2000), options);
}

inline Problem problem_of(const std::string& hand, const Object& object,
                          const Eigen::Isometry3d& X_WO) {
  const RobotWithHand given = robot_with_hand(hand);
  return {given.robot, given.hand, object, X_WO, {}, given.robot.state("home"), {}, {}, {}};
}

}  // namespace graspless::clasp
