// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/goal/goal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "graspless/fingertip/fingertip.hpp"

#include "complaint.hpp"

namespace graspless::fingertip {
namespace {

Eigen::Isometry3d on_floor(double x, double y, double yaw, double height) {
  Eigen::Isometry3d X(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  X.translation() << x, y, height;
  return X;
}

/// On the side that was in front (along x).
Eigen::Isometry3d tumbled_forward() {
  return Eigen::Isometry3d(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY()));
}

/// A block of 5 x 6 x 10 cm standing on end.
Problem block_problem(const Eigen::Isometry3d& X_WO_goal, std::vector<Plane> walls = {}) {
  Goal goal;
  goal.X_WO_start = on_floor(0, 0, 0, 0.05);
  goal.X_WO_goal = X_WO_goal;
  goal.slide_step = 0.02;
  goal.turn_step = M_PI / 18;
  walls.insert(walls.begin(), Plane{});
  return {Object::box("block", {0.05, 0.06, 0.1}, 1), {}, std::move(walls), {0.5, 0.5}, goal, {}};
}

Options coarse(Search search = Search::fast) {
  Options options;
  options.locations_per_side = 4;
  options.explain = false;
  options.search = search;
  return options;
}

void expect_holds(const Problem& problem, const Options& options, const Plan& plan) {
  for (const std::string& fault : check(problem, plan, options)) ADD_FAILURE() << fault;
}

TEST(Goal, WithoutTumblesIsASlide) {
  const Problem problem = block_problem(on_floor(0.1, 0, 0, 0.05));
  Problem as_path = problem;
  as_path.motion = slide_path(on_floor(0, 0, 0, 0.05), {0.1, 0, 0}, 5);
  const Options options = coarse();
  const Plan plan = fingertip::plan(problem, options), expected = fingertip::plan(as_path, options);
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan.cost, expected.cost, 1e-9);
  EXPECT_NEAR(plan.lower_bound, plan.cost, 1e-9);
  EXPECT_EQ(plan.statistics.candidates, 1);
  expect_holds(problem, options, plan);
}

TEST(Goal, APoseWithRoundedAnglesIsReached) {
  Eigen::Isometry3d X_WO_goal(Eigen::AngleAxisd(3.14159, Eigen::Vector3d::UnitY()));
  X_WO_goal.translation() << 0.1, 0, 0.05;
  Problem problem = block_problem(X_WO_goal);
  std::get<Goal>(problem.motion).max_tumbles = 2;
  const Options options = coarse();
  const Plan plan = fingertip::plan(problem, options, planning::Budget{100});
  ASSERT_TRUE(plan) << plan.reason;
  expect_holds(problem, options, plan);
  std::get<Goal>(problem.motion).X_WO_goal.translation().x() += 1e-5;
  EXPECT_FALSE(check(problem, plan, options).empty());
}

TEST(Goal, SlidesAndTumblesToAPoseAndFace) {
  const Problem problem = block_problem(on_floor(0.2, 0.05, 0.4, 0.025) * tumbled_forward());
  const Options options = coarse();
  const Plan plan = fingertip::plan(problem, options);
  ASSERT_TRUE(plan) << plan.reason;
  EXPECT_TRUE(
      plan.segments.front().X_WO.front().isApprox(std::get<Goal>(problem.motion).X_WO_start, 1e-9));
  EXPECT_TRUE(
      plan.segments.back().X_WO.back().isApprox(std::get<Goal>(problem.motion).X_WO_goal, 1e-9));
  int tumbles = 0;
  for (const Segment& segment : plan.segments) tumbles += segment.name == "tumble" ? 1 : 0;
  EXPECT_EQ(tumbles, 1);
  EXPECT_LE(plan.lower_bound, plan.cost);
  expect_holds(problem, options, plan);
}

TEST(Goal, EnginesAgree) {
  const Problem problem = block_problem(on_floor(0.12, 0.04, 0.3, 0.05));
  Options options = coarse();
  options.locations_per_side = 2;
  const Plan fast = plan(problem, options);
  options.search = Search::dijkstra;
  const Plan dijkstra = plan(problem, options);
  ASSERT_TRUE(fast);
  ASSERT_TRUE(dijkstra);
  EXPECT_NEAR(fast.cost, dijkstra.cost, 1e-9);
}

TEST(Goal, IsTheBestOfItsPathsHoweverCheapRegraspsAre) {
  const Problem problem = block_problem(on_floor(0.12, 0.04, 0.3, 0.05));
  const Goal& goal = std::get<Goal>(problem.motion);
  const ContactStates states(problem.object);
  const int face = states.standing(goal.X_WO_start, problem.planes.front(), 1e-6);
  Options options = coarse();
  options.locations_per_side = 2;
  for (const double regrasp_cost : {0.02, 0.13, 0.14}) {
    options.regrasp_cost = regrasp_cost;
    double best = std::numeric_limits<double>::infinity();
    for (const Path& path : goal_paths(problem, goal, states, face, {})) {
      Problem as_path = problem;
      as_path.motion = path;
      const Plan plan = fingertip::plan(as_path, options);
      if (plan) best = std::min(best, plan.cost);
    }
    const Plan plan = fingertip::plan(problem, options);
    ASSERT_TRUE(plan);
    EXPECT_LE(plan.lower_bound, best * (1 + 1e-9)) << regrasp_cost;
    EXPECT_NEAR(plan.cost, best, 2e-3 * best) << regrasp_cost;
  }
}

TEST(Goal, TheWholeProblemMayTurn) {
  const Eigen::Isometry3d X_goal = on_floor(0.15, 0, 0, 0.025) * tumbled_forward();
  const Problem problem = block_problem(X_goal);
  Problem turned = problem;
  const Eigen::Isometry3d X = on_floor(0.3, -0.1, 0.8, 0);
  Goal& goal = std::get<Goal>(turned.motion);
  goal.X_WO_start = X * goal.X_WO_start;
  goal.X_WO_goal = X * goal.X_WO_goal;
  const Options options = coarse();
  const Plan a = plan(problem, options), b = plan(turned, options);
  ASSERT_TRUE(a);
  ASSERT_TRUE(b);
  EXPECT_NEAR(a.cost, b.cost, 1e-7);
}

TEST(Goal, AWallBehindTheGoalIsKept) {
  // The block comes to lie in a corner, flush with both walls.
  const Problem problem = block_problem(
      on_floor(0.2, 0, 0, 0.025) * tumbled_forward(),
      {{"ahead", -Eigen::Vector3d::UnitX(), -0.25}, {"beside", Eigen::Vector3d::UnitY(), -0.03}});
  const Options options = coarse();
  const Plan plan = fingertip::plan(problem, options);
  ASSERT_TRUE(plan) << plan.reason;
  expect_holds(problem, options, plan);
}

TEST(Goal, SaysThatTheFaceIsOutOfReach) {
  Problem problem = block_problem(on_floor(0.2, 0, 0, 0.025) * tumbled_forward());
  std::get<Goal>(problem.motion).max_tumbles = 0;
  const Plan plan = fingertip::plan(problem, coarse());
  EXPECT_EQ(plan.status, Status::no_location);
  EXPECT_EQ(plan.limit, "reach of the lattice");
  EXPECT_NE(plan.reason.find("takes 1 tumble, and max_tumbles is 0"), std::string::npos)
      << plan.reason;
}

TEST(Goal, SaysWhatStandsInTheWay) {
  // A bar across the way, too long to go round.
  Problem problem = block_problem(on_floor(0.4, 0, 0, 0.05));
  problem.obstacles.push_back(
      {"bar", {{geometry::Box{{0.02, 4, 0.02}}}}, on_floor(0.2, 0, 0, 0.02)});
  std::get<Goal>(problem.motion).max_tumbles = 0;
  const Plan plan = fingertip::plan(problem, coarse());
  EXPECT_EQ(plan.status, Status::no_location);
  EXPECT_NE(plan.reason.find("bar"), std::string::npos) << plan.reason;
}

void expect_refused(const Problem& problem, const std::string& words) {
  graspless::expect_refused([&] { plan(problem, coarse()); }, words);
}

TEST(Goal, RefusesPosesInWhichTheObjectDoesNotStand) {
  expect_refused(block_problem(on_floor(0.2, 0, 0, 0.06)), "floats");
  expect_refused(block_problem(on_floor(0.2, 0, 0, 0.04)), "inside plane 'floor'");
  // On an edge: it touches the floor, but does not stand.
  const double tilt = 0.3, height = 0.05 * std::cos(tilt) + 0.025 * std::sin(tilt);
  Eigen::Isometry3d on_edge = on_floor(0.2, 0, 0, height);
  on_edge.rotate(Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()));
  expect_refused(block_problem(on_edge), "flush on 'floor'");
  expect_refused(block_problem(on_floor(0, 0, 0, 0.05)), "must differ");
  expect_refused(
      block_problem(on_floor(0.2, 0, 0, 0.05), {{"wall", -Eigen::Vector3d::UnitX(), -0.21}}),
      "inside plane 'wall'");
}

TEST(Goal, RefusesToLeaveAnObjectWhereItTipsOver) {
  Problem problem = block_problem(on_floor(0.2, 0, 0, 0.025) * tumbled_forward());
  problem.object = problem.object.with_com({0, 0, 0.05});
  expect_refused(problem, "tip over");
}

}  // namespace
}  // namespace graspless::fingertip
