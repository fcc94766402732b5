// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sampling/downsample.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "geometry/clouds.hpp"

namespace graspless::geometry {
namespace {

TEST(DownsampleTo, IsNearTheCountOnSurfacesAndInVolumes) {
  Eigen::Matrix3Xd line = random_cloud(20000, 2);
  line.bottomRows(2) *= 1e-4;
  for (const Eigen::Matrix3Xd& cloud :
       {sphere_cloud(0.3, 20000), torus(1, 0.05, 0.01), random_cloud(20000, 1), line}) {
    const std::vector<int> kept = downsample_to(cloud, 1000);
    EXPECT_NEAR(static_cast<double>(kept.size()), 1000, 100);
    EXPECT_EQ(std::adjacent_find(kept.begin(), kept.end(), std::greater_equal<>()), kept.end());
    EXPECT_GE(kept.front(), 0);
    EXPECT_LT(kept.back(), cloud.cols());
  }
}

TEST(DownsampleTo, EndsWhereThePointsAreFewerThanTheCells) {
  Eigen::Matrix3Xd few = random_cloud(20, 3);
  const Eigen::Matrix3Xd repeated = few.replicate(1, 100);
  EXPECT_LE(downsample_to(repeated, 1000).size(), 20u);
  EXPECT_EQ(downsample_to(Eigen::Matrix3Xd::Ones(3, 200), 50).size(), 1u);
}

}  // namespace
}  // namespace graspless::geometry
