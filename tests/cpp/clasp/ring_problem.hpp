// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The smallest thing that can be clasped: a ring, standing up in front of an arm.
#pragma once

#include <cmath>
#include <string>

#include "graspless/clasp/clasp.hpp"

#include "clasp/hands.hpp"

namespace graspless::clasp {

/// Points on a torus about the x axis [m].
inline Eigen::Matrix3Xd ring_cloud(double radius, double thickness, int round = 48,
                                   int across = 8) {
  Eigen::Matrix3Xd p(3, round * across);
  for (int i = 0; i < round; ++i) {
    for (int k = 0; k < across; ++k) {
      const double a = 2 * M_PI * (i + 0.5 * (k % 2)) / round, b = 2 * M_PI * k / across;
      const double r = radius + thickness / 2 * std::cos(b);
      p.col(i * across + k) << thickness / 2 * std::sin(b), r * std::cos(a), r * std::sin(a);
    }
  }
  return p;
}

/// A ring of 24 cm in front of the KR 5, whose hand looks at it.
inline Problem ring_problem(const std::string& name = "kr5_sdh") {
  static const Object ring = Object::from_cloud("ring", ring_cloud(0.12, 0.02));
  const RobotWithHand r = robot_with_hand(name);
  Problem problem{r.robot, r.hand, ring, Eigen::Isometry3d::Identity(), {}, at_home(r, "open"),
                  {},      {},     {}};
  problem.X_WO.translation() = Eigen::Vector3d(0.6, 0, 0.5);
  return problem;
}

}  // namespace graspless::clasp
