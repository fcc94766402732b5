// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/placement.hpp"

#include <random>

#include <gtest/gtest.h>

#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

Planar at(double x, double y, double yaw = 0) { return planar(flat(x, y, yaw)); }

TEST(Placement, OfASquareOverTheRightEdge) {
  const Problem problem = simple_problem();  // 10 cm square, table edge at y = 0.35
  Options options;
  options.com_margin = 0.01;
  const Placement place = placement(problem, options, at(0.65, 0.33));
  EXPECT_TRUE(place.sticks_out);
  EXPECT_NEAR(place.overhang, 0.03, 0.006);  // the points are a grid of 6 mm
  EXPECT_TRUE(place.edge.inward.isApprox(Eigen::Vector2d(0, -1), 1e-12));
  EXPECT_NEAR(place.out_center.x(), 0.65, 0.004);
  EXPECT_TRUE(place.com_inside);
  EXPECT_FALSE(placement(problem, options, at(0.65, 0.345)).com_inside);
  EXPECT_FALSE(placement(problem, options, at(0.65, 0.2)).sticks_out);
}

TEST(Object, OutermostPointsContainTheFarthestInEveryDirection) {
  std::mt19937_64 rng(1);
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  Eigen::Matrix3Xd cloud(3, 500);
  for (auto p : cloud.colwise()) p << uniform(rng), uniform(rng), 0.002;
  const Object grid = Object::from_polygon("grid", geometry::square(.1), .005, 1e-3);
  for (const Object& object : {grid, Object::from_cloud("cloud", cloud)}) {
    EXPECT_LE(object.outermost().cols(), object.points().cols());
    for (int i = 0; i < 1000; ++i) {
      const Eigen::RowVector2d along(uniform(rng), uniform(rng));
      EXPECT_EQ((along * object.points()).minCoeff(), (along * object.outermost()).minCoeff());
    }
  }
  EXPECT_EQ(grid.points().cols(), 100 * 100);
  EXPECT_EQ(grid.outermost().cols(), 2 * 100);
}

TEST(Object, SharesItsPointsWithItsCopies) {
  const Object object = Object::from_polygon("square", geometry::square(.1), .005);
  EXPECT_EQ(object.with_mass(0.2).points().data(), object.points().data());
  EXPECT_EQ(object.with_com({0.01, 0, 0}).depths().data(), object.depths().data());
}

TEST(Placement, SticksOutByThePointsThatTheSupportDoesNotContain) {
  std::vector<Support> supports = tables();
  supports.emplace_back(
      geometry::Polygon(columns({{.3, -.35}, {1, -.35}, {1, 0}, {.65, 0}, {.65, .35}, {.3, .35}})),
      Eigen::Isometry3d::Identity());
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> x(.25, 1.05), y(-.4, .4), yaw(-3, 3);
  int num_out = 0;
  for (const Support& support : supports) {
    const Problem problem = make_problem(support, objects()[1], flat(.6, -.1, 0));
    const Eigen::Matrix2Xd& points = problem.object.points();
    for (int i = 0; i < 500; ++i) {
      const Planar object_S = at(x(rng), y(rng), yaw(rng));
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      int count = 0;
      for (const auto& p_O : points.colwise()) {
        const Eigen::Vector2d p = object_S * Eigen::Vector2d(p_O);
        if (support.polygon().contains(p)) continue;
        sum += p;
        ++count;
      }
      const Placement place = placement(problem, Options{}, object_S);
      EXPECT_EQ(place.sticks_out, count > 0);
      num_out += count > 0;
      if (&support == &supports[1] && count > 0 && count < points.cols() / 2) {
        EXPECT_NEAR((place.out_center - sum / count).norm(), 0, 1e-12);  // a crescent
      }
    }
  }
  EXPECT_GT(num_out, 500);
}

TEST(Placement, OfTwoProngsTakesTheLonger) {
  const geometry::Polygon fork(columns({{-.06, -.05},
                                        {.06, -.05},
                                        {.06, .04},
                                        {.03, .04},
                                        {.03, -.02},
                                        {-.03, -.02},
                                        {-.03, .06},
                                        {-.06, .06}}));
  const Problem problem =
      make_problem(tables()[0], Object::from_polygon("fork", fork, .005), flat(0.65, 0, 0));
  const Placement place = placement(problem, Options{}, at(0.65, 0.33));  // the edge is at y 0.35
  EXPECT_NEAR(place.out_center.x(), 0.65 - 0.045, 0.004);
  EXPECT_NEAR(place.overhang, 0.04, 0.006);
}

TEST(Placement, DrawnPosesAreValidByConstruction) {
  std::mt19937_64 rng(1);
  for (const Support& table : tables()) {
    std::discrete_distribution<int> edges = usable_edges(table);
    for (const Object& object : objects()) {
      const Problem problem = make_problem(table, object, flat(0.6, 0, 0));
      const Options options;
      int drawn = 0, valid = 0;
      for (int i = 0; i < 200; ++i) {
        const geometry::Polygon::Edge edge = table.polygon().edge(edges(rng));
        const auto pose = draw_graspable_pose(problem, options, edge, rng);
        if (!pose) continue;
        ++drawn;
        const Placement place = placement(problem, options, *pose);
        valid += place.overhang >= options.min_overhang && place.com_inside;
      }
      EXPECT_GT(drawn, 100);
      EXPECT_GT(valid, 0.7 * drawn);  // not at corners, where another edge is nearer
    }
  }
}

TEST(Placement, ADiscOfFiveCentimetresCannotStickOutEnoughWithTheMargin) {
  const Problem problem = make_problem(tables()[0], objects()[1].scaled(0.5), flat(0.6, 0, 0));
  std::mt19937_64 rng(1);
  const geometry::Polygon::Edge edge = problem.support.polygon().edge(0);
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(draw_graspable_pose(problem, Options{}, edge, rng));
}

TEST(Placement, GraspPoseIsLevelAndFacesTheEdge) {
  const Problem problem = simple_problem();
  const Placement place = placement(problem, Options{}, at(0.65, 0.33));
  for (const int roll : {0, 1}) {
    const Eigen::Isometry3d X_WH = grasp_pose(problem, place, roll);
    EXPECT_NEAR(X_WH.linear().determinant(), 1, 1e-12);
    EXPECT_TRUE(X_WH.linear().col(2).isApprox(Eigen::Vector3d(0, -1, 0), 1e-12));
    EXPECT_NEAR(std::abs(X_WH.linear()(2, 1)), 1, 1e-12);
    EXPECT_NEAR(X_WH.translation().z(), 0.0025, 1e-12);
    const Eigen::Isometry3d back = grasp_pose(problem, place, roll, 0.06);
    EXPECT_NEAR((back.translation() - X_WH.translation()).y(), 0.06, 1e-12);
  }
}

TEST(Placement, GravityCountsOnATiltedSupport) {
  const Eigen::Isometry3d X_WS(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()));
  const Support table(geometry::square(1), X_WS);
  const Object tall =
      Object::from_polygon("tall", geometry::square(.1), .04);  // its middle is 2 cm up
  Problem problem = make_problem(table, tall, flat(0, 0, 0));
  // Tilted about x, +y is uphill: the centre of mass stands 2 cm tan(0.5) further downhill.
  const double shift = 0.02 * std::tan(0.5);
  EXPECT_TRUE(is_com_inside(problem, at(0, -0.5 + shift + 0.001), 0));
  EXPECT_FALSE(is_com_inside(problem, at(0, -0.5 + shift - 0.001), 0));
}

}  // namespace
}  // namespace graspless::slide
