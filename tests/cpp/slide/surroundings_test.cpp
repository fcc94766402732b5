// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/surroundings.hpp"

#include <algorithm>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "graspless/scene/scene.hpp"

#include "complaint.hpp"
#include "paths.hpp"
#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

TEST(Surroundings, NothingTouchesOnThePathsOfPlans) {
  std::mt19937_64 rng(7);
  for (const Support& table : tables()) {
    const Problem problem =
        make_problem(table, objects()[0], random_pose(table, objects()[0], rng));
    const Plan found = plan(problem, {}, seeded(1));
    if (!found) continue;
    Surroundings around(problem);
    for (const Segment& segment : found.segments) {
      for (std::size_t row = 0; row < segment.positions.size(); ++row) {
        EXPECT_TRUE(around.touching(segment.name, segment.positions[row], segment.object_poses[row])
                        .empty())
            << segment.name << " row " << row;
      }
    }
  }
}

TEST(Surroundings, AgreesWithASceneOnRandomConfigurations) {
  Problem problem = simple_problem();
  problem.obstacles.push_back(
      {"wall", {geometry::PlacedShape{geometry::Box{{0.1, 0.6, 0.4}}}}, flat(0.4, 0.6, 0.3)});
  scene::Scene scene(problem.robot);
  scene.keep_links_apart(5e-4, problem.robot.group(problem.hand.arm), {});
  scene.add_obstacle("support", problem.support.solid(), problem.support.X_WS());
  scene.add_obstacle("wall", problem.obstacles[0].shapes, problem.obstacles[0].X_WB);
  Surroundings around(problem);
  std::mt19937_64 rng(3);
  int num_touching = 0;
  for (int i = 0; i < 300; ++i) {
    Eigen::VectorXd q = problem.q_home;
    for (int joint : problem.robot.group(problem.hand.arm)) {
      q[joint] = std::uniform_real_distribution<double>(problem.robot.lower()[joint],
                                                        problem.robot.upper()[joint])(rng);
    }
    const bool touches = !around.touching("reach", q, problem.X_WO_start).empty();
    EXPECT_EQ(touches, !scene.is_free(q)) << q.transpose();
    num_touching += touches;
  }
  EXPECT_GT(num_touching, 20);
  EXPECT_LT(num_touching, 280);
}

const Segment& segment_of(const Plan& plan, const std::string& name) {
  for (const Segment& segment : plan.segments) {
    if (segment.name == name) return segment;
  }
  throw std::runtime_error("no segment " + name);
}

TEST(Surroundings, NamesAnObstacleInTheWayOfTheObject) {
  Problem problem = simple_problem();
  const Plan found = plan(problem, {}, seeded(1));
  ASSERT_TRUE(found) << found.reason;
  const Segment& slide = segment_of(found, "slide");
  const Eigen::Isometry3d at = slide.object_poses.back();
  problem.obstacles.push_back(
      {"stop", {geometry::PlacedShape{geometry::Box{{.01, .01, .02}}}}, at});
  Surroundings around(problem);
  const auto touching = around.touching("slide", slide.positions.back(), at);
  EXPECT_NE(std::find(touching.begin(), touching.end(), "object - stop"), touching.end());
}

TEST(Surroundings, RaisesTheSupport) {
  const Problem problem = simple_problem();
  const Plan found = plan(problem, {}, seeded(1));
  ASSERT_TRUE(found) << found.reason;
  const Segment& approach = segment_of(found, "approach");
  Surroundings around(problem);
  const auto touching = [&](double rise) {
    return around.touching("approach", approach.positions.back(), problem.X_WO_start, rise);
  };
  EXPECT_TRUE(touching(0).empty());
  EXPECT_FALSE(touching(0.1).empty());
  EXPECT_TRUE(touching(-0.1).empty());
}

TEST(Surroundings, OutlivesTheProblemAndMayBeMoved) {
  auto problem = std::make_unique<Problem>(simple_problem());
  const Eigen::VectorXd q = problem->q_home;
  const Eigen::Isometry3d X_WO = problem->X_WO_start;
  Surroundings first(*problem);
  problem.reset();
  Surroundings second = std::move(first);
  EXPECT_TRUE(second.touching("approach", q, X_WO).empty());
}

TEST(Surroundings, NamesBadArguments) {
  const Problem problem = simple_problem();
  Surroundings around(problem);
  const Eigen::Isometry3d X = problem.X_WO_start;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { around.touching("push", problem.q_home, X); }, "'push'");
  expect_refused([&] { around.touching("slide", Eigen::VectorXd::Zero(2), X); }, "q ");
  Eigen::Isometry3d bad = X;
  bad.translation().x() = nan;
  expect_refused([&] { around.touching("slide", problem.q_home, bad); }, "X_WO");
  expect_refused([&] { around.touching("slide", problem.q_home, X, nan); }, "rise");
}

TEST(Surroundings, KeepsLinksApart) {
  const Problem problem = simple_problem();
  Surroundings around(problem);
  const auto touching = [&](double apart) {
    return around.touching("reach", bent_home(apart), problem.X_WO_start);
  };
  EXPECT_TRUE(touching(0.0007).empty());
  ASSERT_EQ(touching(0.0003).size(), 1U);
  EXPECT_NE(touching(0.0003)[0].find("hand_base"), std::string::npos);
  Problem bent = problem;
  bent.q_home = bent_home(0.0003);
  EXPECT_TRUE(Surroundings(bent).touching("reach", bent.q_home, problem.X_WO_start).empty());
}

}  // namespace
}  // namespace graspless::slide
