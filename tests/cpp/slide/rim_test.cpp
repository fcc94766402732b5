// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Objects that may rest on their rims alone, on uneven pads, and grasps near the edge.
#include "slide/task/rim.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "slide/friction/course.hpp"
#include "slide/placement.hpp"
#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

using Eigen::Vector2d;

/// Options of a planner that ignores lag.
Options of_any_lag() {
  Options options;
  options.refuse_lag = false;
  return options;
}

/// Least distance over which the points on an outline and on the support lie beyond `com`, in any
/// direction [m].
double least_reach(const Problem& problem, const Planar& object_S, const Vector2d& com) {
  const geometry::Polygon& rim = problem.object.outline();
  std::vector<Vector2d> held;
  for (int i = 0; i < rim.size(); ++i) {
    for (double t = 0; t < 1; t += 0.002) {
      const Vector2d p = object_S * Vector2d(rim.edge(i).a + t * (rim.edge(i).b - rim.edge(i).a));
      if (problem.support.polygon().contains(p)) held.push_back(p);
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (double angle = 0; angle < 2 * M_PI; angle += 0.005) {
    const Vector2d u(std::cos(angle), std::sin(angle));
    double reach = -std::numeric_limits<double>::infinity();
    for (const Vector2d& p : held) reach = std::max(reach, u.dot(p - com));
    least = std::min(least, reach);
  }
  return least;
}

TEST(Rim, FrictionActsAsFarOutAsTwoPlacesOnIt) {
  const Vector2d o(0, 0);
  EXPECT_NEAR(rim_distance(disc(0.1, 200, o), o), 0.1, 1e-4);
  EXPECT_NEAR(rim_distance(geometry::square(0.2), o), 0.1 * std::sqrt(2), 1e-3);
  // Of two places 2 and 6 cm away, the nearer one bears three quarters.
  const geometry::Polygon bar(
      columns({{-0.02, -0.001}, {0.06, -0.001}, {0.06, 0.001}, {-0.02, 0.001}}));
  EXPECT_NEAR(rim_distance(bar, o), 0.75 * 0.02 + 0.25 * 0.06, 2e-4);
  std::mt19937_64 rng(1);
  for (int i = 0; i < 50; ++i) {
    const geometry::Polygon outline = disc(0.05 + 0.001 * i, 3 + i % 9, o);
    const Vector2d c = geometry::random_point(outline, rng);
    if (!outline.contains(c)) continue;
    double largest = 0;  // of places on the corners and sides of the outline
    for (double angle = 0; angle < M_PI; angle += 0.01) {
      const Vector2d u(std::cos(angle), std::sin(angle));
      const auto way = [&](const Vector2d& along) {
        double far = 0;
        while (outline.contains(c + (far + 1e-4) * along)) far += 1e-4;
        return far;
      };
      const double a = way(u), b = way(-u);
      if (a + b > 0) largest = std::max(largest, 2 * a * b / (a + b));
    }
    EXPECT_NEAR(rim_distance(outline, c), largest, 1e-3 + 0.03 * largest);
  }
}

TEST(Rim, ADiscOverACornerIsHeldByTheRestOfItsRim) {
  std::mt19937_64 rng(2);
  std::uniform_real_distribution<double> near(-0.07, 0.07);
  int held = 0, tips = 0, only_by_corner = 0;
  for (int i = 0; i < 300; ++i) {
    Problem problem = simple_problem();
    problem.object = objects()[static_cast<std::size_t>(i) % 3];
    Planar object_S = Planar::Identity();
    object_S.linear() = Eigen::Rotation2Dd(0.1 * i).toRotationMatrix();
    object_S.translation() =
        problem.support.polygon().vertices().col(i % 4) + Vector2d(near(rng), near(rng));
    const Vector2d com = com_foot(problem, object_S);
    const double reach = least_reach(problem, object_S, com);
    if (std::abs(reach - 0.01) < 0.003) continue;
    EXPECT_EQ(is_held_by_rim(problem, object_S, 0.01), reach > 0.01) << i << ", " << reach;
    ++(reach > 0.01 ? held : tips);
    only_by_corner += reach < 0.01 && is_com_inside(problem, object_S, 0.01);
  }
  EXPECT_GT(std::min({held, tips, only_by_corner}), 10);
}

TEST(Rim, AHollowObjectIsNotSlidOverACorner) {
  Problem flat = simple_problem();
  flat.object = Object::from_polygon("plate", disc(0.09, 60, {0, 0}), 0.01);
  Problem hollow = flat;
  hollow.object = flat.object.with_hollow(true);
  EXPECT_TRUE(hollow.object.is_hollow());
  EXPECT_NEAR(hollow.object.lever(), 1.5, 0.05);
  EXPECT_EQ(hollow.object.with_hollow(false).lever(), 1);
  int corners = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Plan over = plan(flat, {}, seeded(seed));
    ASSERT_TRUE(over) << over.reason;
    const Planar goal = planar(flat.support.X_WS().inverse() * over.X_WO_goal);
    const bool tips = least_reach(flat, goal, com_foot(flat, goal)) < 0.006;
    const std::string told = joined(check(hollow, over));
    EXPECT_EQ(told.find("resting on its rim alone") != std::string::npos, tips) << told;
    corners += tips;
    if (seed > 8) continue;
    const Plan safe = plan(hollow, {}, seeded(seed));
    ASSERT_TRUE(safe) << safe.reason;
    EXPECT_EQ(joined(check(hollow, safe)), "");
  }
  EXPECT_GT(corners, 0);
}

TEST(Rim, NoWorldEndsWithTheObjectTippingOnItsRim) {
  Problem flat = simple_problem();
  flat.object = Object::from_polygon("plate", disc(0.09, 60, {0, 0}), 0.01).with_mass(0.3);
  Problem hollow = flat;
  hollow.object = flat.object.with_hollow(true);
  Options bold;
  bold.com_margin = 0.001;
  int tips = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const Plan over = plan(flat, bold, seeded(seed));
    if (!over) continue;
    double least = 1;
    for (const Planar& end : course(hollow, bold, pressed_rows(hollow, over)).ends)
      least = std::min(least, least_reach(hollow, end, com_foot(hollow, end)));
    if (least > -0.006 && least < 0) continue;
    const std::string told = joined(check(hollow, over, bold));
    EXPECT_EQ(told.find("friction may leave the object tipping") != std::string::npos, least < 0)
        << seed << ", " << least << "\n"
        << told;
    tips += least < 0;
    if (seed > 5) continue;
    if (const Plan safe = plan(hollow, bold, seeded(seed))) {
      EXPECT_EQ(joined(check(hollow, safe, bold)), "") << seed;
    }
  }
  EXPECT_GT(tips, 0);
}

TEST(Rim, AnEndThatTipsIsALagTooLarge) {
  Problem problem = simple_problem();
  const Vector2d corner = problem.support.polygon().vertices().col(0),
                 inward = (problem.support.polygon().centroid() - corner).normalized();
  const Object plate = Object::from_polygon("plate", disc(0.09, 60, {0, 0}), 0.01);
  Planar goal = Planar::Identity(), end = goal;
  for (const double d : {0.03, 0.08, 0.1}) {
    goal.translation() = corner + (d + 0.009) * inward;
    end.translation() = corner + d * inward;
    const Vector2d grasp = goal.translation();
    const bool tips = least_reach(problem, end, end.translation()) < 0;
    EXPECT_EQ(tips, d < 0.09) << d;  // by Thales, while the corner is under the plate
    problem.object = plate;
    EXPECT_FALSE(broken_by_lag(problem, goal, grasp, {end})) << d;
    EXPECT_TRUE(is_supported(problem, end, 0)) << d;
    problem.object = plate.with_hollow(true);
    EXPECT_EQ(broken_by_lag(problem, goal, grasp, {end}).has_value(), tips) << d;
    EXPECT_EQ(is_supported(problem, end, 0), !tips) << d;
  }
}

TEST(Rim, ASinglePointHasNoLever) {
  const Object plate = Object::from_polygon("plate", geometry::square(0.1), 0.01, 0.2);
  ASSERT_EQ(plate.points().cols(), 1);
  EXPECT_EQ(plate.with_hollow(true).lever(), 1);
}

/// The pad holds a plate that rests on its middle, but turns one that rests on its rim less far.
TEST(Rim, TheTubeKnowsBothRims) {
  Problem problem = simple_problem();
  const Options any = of_any_lag();
  int wider = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Plan found = plan(problem, any, seeded(seed));
    ASSERT_TRUE(found);
    Problem hollow = problem;
    hollow.object = problem.object.with_hollow(true).with_mass(0.4);
    problem.object = problem.object.with_mass(0.4);
    const Tube flat = tube(problem, found, any), rim = tube(hollow, found, any);
    for (std::size_t row = 0; row < flat.angle.size(); ++row)
      EXPECT_GE(rim.angle[row], flat.angle[row]);
    wider += rim.angle.back() > flat.angle.back() + 0.01;
  }
  EXPECT_GT(wider, 3);
}

TEST(Rim, AnUnevenPadWidensTheTube) {
  Problem problem = simple_problem();
  problem.object = problem.object.with_mass(0.3);
  const Options any = of_any_lag();
  int wider = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Plan found = plan(problem, any, seeded(seed));
    ASSERT_TRUE(found);
    double before = 0;
    for (const double share : {0.0, 0.3, 0.7}) {
      Options uneven = any;
      uneven.pad_spread = share;
      const double now = tube(problem, found, uneven).angle.back();
      if (share == 0) {
        EXPECT_NEAR(now, found.tube.angle.back(), 1e-9);
      }
      EXPECT_GE(now, before - 1e-12);
      wider += now > before + 0.01 && share > 0;
      before = now;
    }
  }
  EXPECT_GT(wider, 3);
}

TEST(Rim, APlanKeepsTheLagOfTheObjectSmall) {
  Problem problem = simple_problem();
  problem.object = problem.object.with_mass(0.5);
  const Options any = of_any_lag();
  int large = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto lag = [&](const Plan& found) {
      return largest_lag(problem, course(problem, {}, pressed_rows(problem, found)).ends,
                         planar(problem.support.X_WS().inverse() * found.X_WO_goal));
    };
    if (const Plan kept = plan(problem, {}, seeded(seed))) {
      EXPECT_LE(lag(kept).angle, kMostLag.angle + 1e-9);
      EXPECT_LE(lag(kept).position, kMostLag.position + 1e-9);
      EXPECT_EQ(joined(check(problem, kept)), "");
    }
    const Plan loose = plan(problem, any, seeded(seed));
    ASSERT_TRUE(loose);
    const Lag of_loose = lag(loose);
    const bool is_large = of_loose.angle > 1.05 * kMostLag.angle;
    large += is_large;
    if (is_large) {
      EXPECT_NE(joined(check(problem, loose)).find("friction may leave the object turned by"),
                std::string::npos);
    }
  }
  EXPECT_GT(large, 5);
}

TEST(Rim, ADeepGraspIsNearerToTheEdge) {
  Problem problem = simple_problem();
  Options deep;
  deep.deep_grasp = true;
  deep.min_overhang = 0.03;
  int deeper = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Plan found = plan(problem, deep, seeded(seed));
    ASSERT_TRUE(found) << found.reason;
    EXPECT_EQ(joined(check(problem, found, deep)), "");
    const Placement place =
        placement(problem, deep, planar(problem.support.X_WS().inverse() * found.X_WO_goal));
    const auto off_edge = [&](const Eigen::Vector3d& p_W) {
      const Eigen::Vector3d p = problem.support.X_WS().inverse() * p_W;
      return -place.edge.inward.dot(p.head<2>() - place.edge.a);
    };
    const double grasp = off_edge(found.X_WH_grasp.translation()),
                 middle = -place.edge.inward.dot(place.out_center - place.edge.a);
    EXPECT_LE(grasp, middle + 1e-9);
    EXPECT_GE(grasp, std::min(middle, 0.01) - 1e-9);
    if (grasp > middle - 1e-6) continue;
    ++deeper;
    Options paper = deep;
    paper.deep_grasp = false;
    EXPECT_NE(joined(check(problem, found, paper)).find("not at the middle of the part"),
              std::string::npos);
  }
  EXPECT_GE(deeper, 3);
}

}  // namespace
}  // namespace graspless::slide
