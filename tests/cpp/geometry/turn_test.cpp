// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/turn.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace graspless::geometry {
namespace {

using Eigen::Vector3d;

TEST(Turn, PutsZOnTheDirection) {
  for (const Vector3d& direction : {Vector3d(0, 0, 2), Vector3d(0, 0, -3), Vector3d(1, 0, 0),
                                    Vector3d(-0.2, 0.5, -0.1), Vector3d(1e-9, 0, -1)}) {
    const Eigen::Quaterniond turn = turn_from_z(direction);
    EXPECT_NEAR(turn.norm(), 1, 1e-12);
    EXPECT_TRUE((turn * Vector3d::UnitZ()).isApprox(direction.normalized(), 1e-7));
  }
}

TEST(Turn, IsTheSmallest) {
  const Vector3d direction(-0.2, 0.5, -0.1);
  const double angle = std::acos(direction.normalized().z());
  EXPECT_NEAR(Eigen::AngleAxisd(turn_from_z(direction)).angle(), angle, 1e-12);
}

}  // namespace
}  // namespace graspless::geometry
