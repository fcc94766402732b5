// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/carry/carry.hpp"

#include <random>

#include <gtest/gtest.h>

#include "carry/problems.hpp"
#include "carry/search.hpp"
#include "complaint.hpp"

namespace graspless::carry {
namespace {

using Eigen::AngleAxisd, Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;

void expect_holds(const Problem& problem, const Options& options = {}) {
  const Plan found = plan(problem, options);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(joined(check(problem, found, options)), "");
  EXPECT_EQ(found.reached, 1);
}

/// A configuration of the arm anywhere within its limits, with the hand as at home.
VectorXd random_arm(const robot::Robot& robot, std::mt19937_64& rng) {
  VectorXd q = robot.state("home");
  for (const int joint : robot.group("arm")) {
    q[joint] =
        std::uniform_real_distribution<double>(robot.lower()[joint], robot.upper()[joint])(rng);
  }
  return q;
}

TEST(Carry, GoesStraightInEveryDirection) {
  for (const robot::Robot* robot : {&wam(), &kr5()}) {
    for (const Vector3d& by :
         {Vector3d(0, 0, 0.1), Vector3d(0.1, 0.02, 0), Vector3d(-0.05, 0.1, 0.05)})
      expect_holds(held_box(*robot, by));
  }
}

TEST(Carry, TurnsToo) {
  for (const robot::Robot* robot : {&wam(), &kr5()}) {
    Problem problem = held_box(*robot, {0, 0, 0});
    problem.X_WO_goal = problem.object.X_WB * AngleAxisd(0.5, Vector3d(1, 0.3, 2).normalized());
    expect_holds(problem);
    problem.X_WO_goal = moved(problem.X_WO_goal, {0.05, -0.04, 0.08});
    expect_holds(problem);
  }
}

TEST(Carry, TurnsHalfWayRoundEitherWay) {
  std::mt19937_64 rng(1);
  std::normal_distribution<double> normal;
  VectorXd q(8);
  q << 0, 0.7, 0, 1.6, 0, 0.84, 0, 0.15;  // the hand points down
  Problem problem = held_box(wam(), q, {0, 0, 0.1});
  const Isometry3d held = problem.object.X_WB;
  int solved = 0;
  for (int i = 0; i < 12; ++i) {
    const Isometry3d X_OF(Eigen::Quaterniond(normal(rng), normal(rng), normal(rng), normal(rng))
                              .normalized());  // another frame of the same object
    problem.object.X_WB = held * X_OF;
    problem.object.shapes[0].X_BG = X_OF.inverse();
    problem.X_WO_goal = Eigen::Translation3d(held.translation()) *
                        AngleAxisd(M_PI, Vector3d::UnitZ()) *
                        Eigen::Translation3d(-held.translation()) * problem.object.X_WB;
    if (i % 2 == 1) problem.X_WO_goal = moved(problem.X_WO_goal, {0, 0, 0.03});
    const Plan found = plan(problem);
    if (!found) continue;
    ++solved;
    EXPECT_EQ(faults_of(problem, found), "") << i;
  }
  EXPECT_GE(solved, 3);
}

TEST(Carry, GoesBackAlongTheSamePath) {
  const Problem there = held_box(wam(), {0.05, 0.1, 0.1});
  const Plan found = plan(there);
  ASSERT_TRUE(found);
  Problem back = there;
  back.q_start = found.segments[0].positions.back();
  back.object.X_WB = found.segments[0].object_poses.back();
  back.X_WO_goal = there.object.X_WB;
  expect_holds(back);
}

TEST(Carry, IsTheSameEveryTime) {
  const Problem problem = held_box(wam(), {0.1, 0.02, 0});
  EXPECT_EQ(plan(problem).segments[0].positions, plan(problem).segments[0].positions);
}

TEST(Carry, NamesTheObstacle) {
  Problem problem = held_box(wam(), {0, 0, 0.2});
  problem.obstacles = {
      box("shelf", {0.5, 0.5, 0.01},
          moved(Isometry3d::Identity(), problem.object.X_WB.translation() - Vector3d(0, 0, 0.15)))};
  problem.X_WO_goal = moved(problem.object.X_WB, {0, 0, -0.25});
  const Plan found = plan(problem);
  EXPECT_EQ(found.status, Status::not_found);
  EXPECT_NE(found.reason.find("'shelf'"), std::string::npos) << found.reason;
  EXPECT_GT(found.reached, 0.1);
  EXPECT_LT(found.reached, 0.6);
  problem.X_WO_goal = moved(problem.object.X_WB, {0, 0, 0.1});
  expect_holds(problem);
}

TEST(Carry, SaysWhatTouchesAtTheStart) {
  Problem problem = held_box(wam(), {0, 0, 0.1});
  problem.obstacles = {box("crate", {0.02, 0.02, 0.02}, moved(problem.object.X_WB, {0, 0, -0.01}))};
  const Plan found = plan(problem);
  EXPECT_EQ(found.status, Status::start_in_collision);
  EXPECT_NE(found.reason.find("'crate'"), std::string::npos) << found.reason;
}

/// A box that lies 0.5 mm deep in a table.
Problem lying() {
  Problem problem = held_box(wam(), {0, 0, 0.1});
  problem.object = box("box", {0.3, 0.3, 0.01}, Isometry3d::Identity());
  problem.object.X_WB.translation() =
      wam().pose(wam().frame("grasp"), problem.q_start).translation() - Vector3d(0, 0, 0.05);
  problem.X_WO_goal = moved(problem.object.X_WB, {0, 0, 0.1});
  problem.obstacles = {box("table", {0.3, 0.3, 0.02}, moved(problem.object.X_WB, {0, 0, -0.0145}))};
  return problem;
}

TEST(Carry, LeavesWhatItRestsOn) {
  Problem problem = lying();
  EXPECT_EQ(plan(problem).status, Status::start_in_collision);
  problem.rests_on = {{"table"}};
  expect_holds(problem);
}

TEST(Carry, IsDrawnOverWhatItRestsOnAndNotPressedInto) {
  Problem problem = lying();
  problem.rests_on = {{"table"}};
  problem.X_WO_goal = moved(problem.object.X_WB, {0.05, 0, 0});
  expect_holds(problem);
  problem.X_WO_goal = moved(problem.object.X_WB, {0, 0, -0.02});
  EXPECT_EQ(plan(problem).status, Status::not_found);
}

/// How many of random carries are found, and how many of them with the free joint at rest.
std::pair<int, int> count_found(const robot::Robot& robot, const Options& options) {
  std::mt19937_64 rng(5);
  int found = 0, straight = 0;
  for (int i = 0; i < 60; ++i) {
    const Problem problem = held_box(robot, random_arm(robot, rng), {0.12, 0.05, 0.1});
    planning::Budget budget;
    budget.iterations = 3000;
    const Plan carried = plan(problem, options, budget);
    if (!carried) continue;
    ++found;
    const double layers = std::ceil(Vector3d(0.12, 0.05, 0.1).norm() / options.step);
    if (carried.statistics.iterations <= static_cast<std::int64_t>(layers)) ++straight;
    EXPECT_EQ(joined(check(problem, carried, options)), "") << i;
  }
  return {found, straight};
}

TEST(Carry, TheFreeJointLeadsAroundObstacles) {
  const auto [found, straight] = count_found(wam(), {});
  EXPECT_GT(straight, 5);
  EXPECT_GT(found, straight);
}

TEST(Carry, ATwistFindsMore) {
  Options twisting;
  twisting.max_twist = 0.6;
  const int without = count_found(kr5(), {}).first;
  EXPECT_GT(without, 2);
  EXPECT_GT(count_found(kr5(), twisting).first, without);
}

TEST(Carry, TheHandKeepsItsPlaceToTheObject) {
  const auto links = links_with(wam(), wam().frame("grasp"), wam().group("arm"));
  const auto has = [&](const char* name) {
    return std::find(links.begin(), links.end(), wam().frame(name)) != links.end();
  };
  EXPECT_TRUE(has("grasp") && has("left_finger") && has("right_finger"));
  EXPECT_FALSE(has("base_link") || has("wam_link_4"));
}

TEST(CarryCheck, FindsWhatIsWrong) {
  const Problem problem = held_box(wam(), {0.1, 0.02, 0});
  const Plan good = plan(problem);
  ASSERT_TRUE(good);
  const std::size_t middle = good.segments[0].positions.size() / 2;
  const auto expect_fault = [&](const Plan& plan, const std::string& words) {
    const std::string faults = joined(check(problem, plan));
    EXPECT_NE(faults.find(words), std::string::npos) << words << " in: " << faults;
  };
  Plan bad = good;
  bad.segments[0].object_poses[middle].translation().z() += 1e-4;
  expect_fault(bad, "the object moves relative to the hand");
  bad = good;
  bad.segments[0].positions[middle][wam().group("arm")[3]] += 0.01;
  expect_fault(bad, "off its straight path");
  bad = good;
  bad.segments[0].positions[middle][wam().group("arm")[6]] += 0.01;
  expect_fault(bad, "turned by");
  bad = good;
  bad.segments[0].positions[middle][wam().joint("left_finger_joint")] += 0.01;
  expect_fault(bad, "a joint outside the arm's group moves");
  bad = good;
  bad.segments[0].positions.pop_back();
  bad.segments[0].object_poses.pop_back();
  expect_fault(bad, "not at its goal");
  bad = good;
  bad.segments[0].positions.erase(bad.segments[0].positions.begin());
  bad.segments[0].object_poses.erase(bad.segments[0].object_poses.begin());
  expect_fault(bad, "is not q_start");
  bad = good;
  bad.joint_names.pop_back();
  expect_fault(bad, "joint names are not the robot's");
}

TEST(CarryCheck, FindsWhatTheHeldObjectTouches) {
  Problem problem = held_box(wam(), {0.1, 0.02, 0});
  const Plan good = plan(problem);
  ASSERT_TRUE(good);
  const Vector3d tip = problem.object.X_WB * Vector3d(0.049, 0, 0);
  problem.obstacles = {box("post", {0.002, 0.002, 0.002},
                           moved(Isometry3d::Identity(), tip + Vector3d(0.1, 0.02, 0)))};
  const std::string faults = joined(check(problem, good));
  EXPECT_NE(faults.find("collision"), std::string::npos) << faults;
  EXPECT_NE(faults.find("post"), std::string::npos) << faults;
}

TEST(CarryValidate, NamesTheField) {
  const Problem good = held_box(wam(), {0, 0, 0.1});
  const auto refused = [&](auto change, const char* words) {
    Problem bad = good;
    change(bad);
    expect_refused([&] { plan(bad); }, words);
  };
  refused([](Problem& p) { p.frame = "hand"; }, "hand");
  refused([](Problem& p) { p.frame = "base_link"; }, "base_link");
  refused([](Problem& p) { p.arm = "leg"; }, "leg");
  refused([](Problem& p) { p.q_start[0] = 9; }, "q_start");
  refused([](Problem& p) { p.X_WO_goal = p.object.X_WB; }, "X_WO_goal");
  refused([](Problem& p) { p.object.shapes.clear(); }, "object.shapes");
  refused([](Problem& p) { p.object.name = "left_finger"; }, "object.name");
  const auto sphere = [](const std::string& name) {
    return Obstacle{name, {{geometry::Sphere{0.1}}}, Isometry3d(Eigen::Translation3d(0, 0, -9))};
  };
  refused(
      [&](Problem& p) {
        p.obstacles = {sphere("block"), sphere("post")};
        p.rests_on = {{"table"}};
      },
      "rests_on[0]: there is no obstacle 'table' (one of: block, post)");
  refused([](Problem& p) { p.obstacles = {p.object}; }, "obstacles[0].name");
  Options options;
  options.step = 0;
  expect_refused([&] { plan(good, options); }, "options.step");
  options = {};
  options.max_twist = -1;
  expect_refused([&] { (void)check(good, Plan{}, options); }, "options.max_twist");
}

}  // namespace
}  // namespace graspless::carry
