// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/polygon.hpp"

#include <limits>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <gtest/gtest.h>

#include "geometry/polygons.hpp"

namespace graspless::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

TEST(Polygon, ContainsAgreesWithCgal) {
  std::mt19937_64 rng(1);
  for (int i = 0; i < 300; ++i) {
    const Polygon polygon = random_star(rng);
    CGAL::Polygon_2<Kernel> oracle;
    for (const auto& v : polygon.vertices().colwise()) oracle.push_back({v.x(), v.y()});
    for (int k = 0; k < 100; ++k) {
      const Eigen::Vector2d p = random_point(polygon, rng);
      EXPECT_EQ(polygon.contains(p), oracle.has_on_bounded_side({p.x(), p.y()}));
    }
  }
}

TEST(Polygon, DepthIsTheSignedDistanceToTheBoundary) {
  std::mt19937_64 rng(2);
  for (int i = 0; i < 50; ++i) {
    const Polygon polygon = random_star(rng);
    const Eigen::Vector2d p = random_point(polygon, rng);
    double nearest = std::numeric_limits<double>::infinity();
    for (int e = 0; e < polygon.size(); ++e) {
      const auto edge = polygon.edge(e);
      for (int k = 0; k <= 2000; ++k) {
        nearest = std::min(nearest, (edge.a + k / 2000.0 * (edge.b - edge.a) - p).norm());
      }
    }
    EXPECT_NEAR(std::abs(polygon.depth(p)), nearest, 1e-3);
    EXPECT_EQ(polygon.depth(p) > 0, polygon.contains(p));
  }
}

TEST(Polygon, HasAMarginWhereItIsDeeper) {
  std::mt19937_64 rng(6);
  int with = 0;
  for (int i = 0; i < 300; ++i) {
    const Polygon polygon = random_star(rng);
    for (int k = 0; k < 100; ++k) {
      const Eigen::Vector2d p = random_point(polygon, rng);
      const double margin = std::uniform_real_distribution<double>(0, 0.05)(rng);
      EXPECT_EQ(polygon.has_margin(p, margin), polygon.depth(p) >= margin);
      with += polygon.has_margin(p, margin);
    }
    const Polygon::Edge edge = polygon.edge(0);
    const Eigen::Vector2d beside = (edge.a + edge.b) / 2 + 1e-6 * edge.inward;
    EXPECT_TRUE(polygon.has_margin(beside, 0.9e-6));
    EXPECT_FALSE(polygon.has_margin(beside, 1.1e-6));
  }
  EXPECT_GT(with, 1000);
}

TEST(Polygon, NearestEdgeHasItsNormalInside) {
  std::mt19937_64 rng(3);
  for (int i = 0; i < 100; ++i) {
    const Polygon polygon = random_star(rng);
    const auto edge = polygon.nearest_edge(random_point(polygon, rng));
    EXPECT_NEAR(edge.inward.norm(), 1, 1e-12);
    EXPECT_TRUE(polygon.contains((edge.a + edge.b) / 2 + 1e-7 * edge.inward));
  }
}

TEST(Polygon, NearestEdgeRoundACornerIsTheOneFartherBeyond) {
  const Polygon polygon = square(1);
  EXPECT_TRUE(polygon.nearest_edge({0.6, 0.7}).inward.isApprox(Eigen::Vector2d(0, -1)));
  EXPECT_TRUE(polygon.nearest_edge({0.7, 0.6}).inward.isApprox(Eigen::Vector2d(-1, 0)));
}

TEST(Polygon, ConvexPartsCoverItWithoutOverlap) {
  std::mt19937_64 rng(4);
  for (int i = 0; i < 100; ++i) {
    const Polygon polygon = random_star(rng);
    const auto parts = polygon.convex_parts();
    double area = 0;
    for (const Polygon& part : parts) {
      EXPECT_TRUE(part.is_convex());
      area += part.area();
    }
    EXPECT_NEAR(area, polygon.area(), 1e-12);
    for (int k = 0; k < 50; ++k) {
      const Eigen::Vector2d p = random_point(polygon, rng);
      int holders = 0;
      for (const Polygon& part : parts) holders += part.contains(p);
      EXPECT_EQ(holders, polygon.contains(p) ? 1 : 0);
    }
  }
}

TEST(Polygon, CentroidMovesWithThePolygon) {
  const Eigen::Vector2d far(1e3, -3e3);
  EXPECT_TRUE(square(0.2).centroid().isZero(1e-15));
  const Polygon moved((l_shape().vertices().colwise() + far).eval());
  EXPECT_TRUE((moved.centroid() - far).isApprox(l_shape().centroid(), 1e-9));
  EXPECT_NEAR(l_shape().area(), 0.8 * 0.3 + 0.3 * 0.5, 1e-12);
}

TEST(Polygon, TakesClockwiseVerticesToo) {
  const Polygon polygon(l_shape().vertices().rowwise().reverse().eval());
  EXPECT_GT(polygon.area(), 0);
  EXPECT_EQ(polygon.contains({0.1, 0.1}), true);
}

TEST(Polygon, RefusesAnEdgeThatItDoesNotHave) {
  const Polygon polygon = l_shape();
  EXPECT_NO_THROW(polygon.edge(polygon.size() - 1));
  EXPECT_THROW(polygon.edge(polygon.size()), std::invalid_argument);
  EXPECT_THROW(polygon.edge(-1), std::invalid_argument);
}

TEST(Polygon, RefusesWhatIsNotOne) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const std::vector<Eigen::Vector2d>& v, const std::string& why) {
    try {
      Polygon(columns(v), "support polygon");
      ADD_FAILURE() << "accepted: " << why;
    } catch (const std::invalid_argument& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find("support polygon"), 0u) << what;
      EXPECT_NE(what.find(why), std::string::npos) << what;
    }
  };
  refused({{0, 0}, {1, 0}}, "at least 3");
  refused({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, "crosses");
  refused({{0, 0}, {1, 0}, {nan, 1}}, "vertex 2 must lie within 10000 m");
  refused({{0, 0}, {1e160, 0}, {0, 1e160}},
          "vertex 1 must lie within 10000 m of the origin along x and y, not at (1e+160, 0)");
  refused({{0, 0}, {1, 0}, {1, 0}, {0, 1}}, "repeats");
  refused({{0, 0}, {1, 0}, {2, 0}}, "crosses");                            // flat
  refused({{0, 0}, {1, 0}, {1, 1}, {0.5, 0}, {0, 1}}, "crosses");          // touches itself
  refused({{0, 0}, {2, 0}, {2, 2}, {3, 3}, {2, 2.0}, {0, 2}}, "crosses");  // antenna
}

}  // namespace
}  // namespace graspless::geometry
