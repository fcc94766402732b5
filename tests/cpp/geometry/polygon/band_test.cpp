// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/band.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "geometry/polygons.hpp"

namespace graspless::geometry {
namespace {

TEST(Band, OfASquareIsItsRim) {
  const Band band(square(0.7), 0.06);
  ASSERT_TRUE(band.exact());
  ASSERT_EQ(band.core().size(), 1u);
  EXPECT_NEAR(band.core()[0].area(), 0.58 * 0.58, 1e-12);
}

TEST(Band, PointsLieNearTheEdges) {
  std::mt19937_64 rng(1);
  for (int i = 0; i < 100; ++i) {
    const Polygon polygon = random_star(rng);
    const Band band(polygon, 0.05);
    for (int k = 0; k < 20; ++k) {
      const auto p = band.sample(rng);
      ASSERT_TRUE(p);
      EXPECT_TRUE(polygon.contains(*p));
      for (const Polygon& core : band.core()) EXPECT_FALSE(core.contains(*p));
    }
    // Mitred at reflex corners: what is near the boundary is in the band, and a little more.
    for (int k = 0; k < 50; ++k) {
      const Eigen::Vector2d p = random_point(polygon, rng);
      const double depth = polygon.depth(p);
      if (depth > 0 && depth < 0.05) {
        EXPECT_TRUE(band.contains(p));
      } else if (depth < 0) {
        EXPECT_FALSE(band.contains(p));
      }
    }
  }
}

TEST(Band, IsDrawnUniformlyByArea) {
  const Band band(square(0.7), 0.06);
  std::mt19937_64 rng(5);
  int right = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) right += band.sample(rng)->x() > 0.29;
  const double share = 0.06 * 0.7 / (0.7 * 0.7 - 0.58 * 0.58);
  EXPECT_NEAR(right / static_cast<double>(n), share, 0.015);
}

TEST(Band, WiderThanThePolygonIsThePolygon) {
  const Band band(square(0.1), 0.06);
  EXPECT_TRUE(band.core().empty());
  EXPECT_TRUE(band.contains({0, 0}));
}

TEST(Band, MarginKeepsAwayFromTheEdge) {
  const Band band(l_shape(), 0.06);
  std::mt19937_64 rng(6);
  for (int i = 0; i < 200; ++i) EXPECT_GE(l_shape().depth(*band.sample(rng, 0.02)), 0.02);
  EXPECT_FALSE(band.sample(rng, 0.5));
}

TEST(Band, RefusesAWidthThatIsNone) {
  EXPECT_THROW(Band(square(1), 0), std::invalid_argument);
  EXPECT_THROW(Band(square(1), -1), std::invalid_argument);
  EXPECT_THROW(Band(square(1), std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(Band(square(1), std::numeric_limits<double>::infinity()), std::invalid_argument);
}

}  // namespace
}  // namespace graspless::geometry
