// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/pull.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;

/// The handle of a bag: a ring in the plane y = 0 around (0, 0, 1), over a heavy body at 0.
const PullCenters kBag{{0, 0, 1}, {0, 0, 0}};
const geometry::ClaspTarget kTop{{0, 0, 1.2}, Vector3d::UnitX()};
const geometry::ClaspTarget kBottom{{0, 0, 0.8}, Vector3d::UnitX()};
const geometry::ClaspTarget kSide{{0.2, 0, 1}, Vector3d::UnitZ()};

TEST(PullScore, AHandleIsLiftedAtItsTop) {
  EXPECT_TRUE(pull_score(kTop, kBag, Vector3d::UnitZ()));
  EXPECT_FALSE(pull_score(kBottom, kBag, Vector3d::UnitZ()));  // back through the hole
  EXPECT_FALSE(pull_score(kSide, kBag, Vector3d::UnitZ()));    // along the segment: it slips
  EXPECT_TRUE(pull_score(kSide, kBag, Vector3d::UnitX()));
}

TEST(PullScore, TheNearerToThePullTheBetter) {
  double last = *pull_score(kTop, kBag, Vector3d::UnitZ());
  for (const double tilt : {0.1, 0.2, 0.4}) {
    const auto score = pull_score(kTop, kBag, Vector3d(std::sin(tilt), 0, std::cos(tilt)));
    ASSERT_TRUE(score);
    EXPECT_LT(*score, last);
    last = *score;
  }
}

TEST(PullScore, AnObjectThatTrailsIsBetterThanOneThatTurns) {
  const PullCenters swings{kBag.loop, {0, 0, 5}};
  EXPECT_GT(*pull_score(kTop, kBag, Vector3d::UnitZ()),
            *pull_score(kTop, swings, Vector3d::UnitZ()));
}

TEST(PullScore, DoesNotDependOnTheFrameOrTheWayRoundTheLoop) {
  const Eigen::Isometry3d X = Eigen::Translation3d(1, -2, 3) *
                              Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()) *
                              Eigen::Isometry3d::Identity();
  const Vector3d pull = Vector3d(0.2, 0.1, 1).normalized();
  const auto score = pull_score(kTop, kBag, pull);
  ASSERT_TRUE(score);
  const auto moved = pull_score({X * kTop.point, -(X.linear() * kTop.tangent)},
                                {X * kBag.loop, X * kBag.object}, X.linear() * pull);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(*moved, *score, 1e-12);
}

}  // namespace
}  // namespace graspless::clasp
