// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/bearing.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

constexpr double kGravity = 9.81;
constexpr double kEffort = 1.5;  // of the joint of the T42, which moves both fingers [Nm]

/// A bar of 16 cm that a T42 with another effort limit slides over the edge.
Problem with_effort(const std::string& effort, double mass) {
  const geometry::Polygon outline(
      columns({{-0.08, -0.04}, {0.08, -0.04}, {0.08, 0.04}, {-0.08, 0.04}}));
  Problem problem =
      make_problem(tables()[0], Object::from_polygon("bar", outline, 0.01), flat(0.6, 0.1, 0.4));
  std::string urdf = problem.robot.urdf();
  const std::string given = " effort=\"2\"";
  for (std::size_t at = urdf.find(given); at != std::string::npos; at = urdf.find(given, at + 1))
    urdf.replace(at, given.size(), effort.empty() ? "" : " effort=\"" + effort + "\"");
  problem.robot = robot::Robot::from_urdf(urdf, problem.robot.options());
  problem.object = problem.object.with_mass(mass);
  return problem;
}

/// The work of three quarters of the motor's effort is that of both forces, when the hand opens.
TEST(SlideBearing, TheMotorBearsTheForcesOnBothFingers) {
  const Problem problem = with_effort("2", 0.1);
  const Plan plan = slide::plan(problem);
  ASSERT_TRUE(plan) << plan.reason;
  const auto held = bearing(problem, plan);
  ASSERT_TRUE(held && plan.max_mass);
  EXPECT_EQ(*plan.max_mass, held->max_mass);
  const robot::Robot& robot = problem.robot;
  const Eigen::VectorXd& q = plan.segments.back().positions.back();
  const Eigen::Isometry3d X_WH = robot.pose(robot.frame("grasp"), q);
  const Eigen::Vector3d p_HC = X_WH.inverse() * (plan.X_WO_goal * problem.object.com());
  EXPECT_NEAR(held->lever, std::max(0.0, p_HC.z()), 1e-9);
  EXPECT_NEAR(held->offset, std::abs(p_HC.x()), 1e-9);

  const double weight = kGravity * held->max_mass;
  const double upper =
      weight * std::max(held->lever / held->depth, held->offset / problem.hand.pad_width - 0.5);
  const int joint = robot.joint("left_finger_joint");
  Eigen::VectorXd open = q;
  open[joint] -= 1e-4 * (robot.state("closed")[joint] > robot.state("open")[joint] ? 1 : -1);
  double work = 0;  // of the forces on both fingers
  for (const std::string name : {"left_finger", "right_finger"}) {
    const int frame = robot.frame(name);
    const Eigen::Isometry3d X_WF = robot.pose(frame, q), moved = robot.pose(frame, open);
    const double side = (X_WH.inverse() * X_WF.translation()).y();
    const Eigen::Vector3d outward = (side > 0 ? 1 : -1) * X_WH.linear().col(1);
    const bool is_lower = outward.z() < 0;
    const Eigen::Vector3d p_W = X_WH * Eigen::Vector3d(0, 0, is_lower ? 0 : -held->depth);
    work += (is_lower ? weight + upper : upper) * outward.dot(moved * (X_WF.inverse() * p_W) - p_W);
  }
  EXPECT_NEAR(work, kEffort * 1e-4, 0.01 * kEffort * 1e-4);
}

/// The depth is that of the outline behind the tips, by a dense sample of it.
TEST(SlideBearing, TheDepthIsThatOfTheOutlineBetweenThePads) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Problem problem = with_effort("2", 0.1);
    planning::Budget budget;
    budget.seed = seed;
    const Plan plan = slide::plan(problem, {}, budget);
    ASSERT_TRUE(plan) << plan.reason;
    const Eigen::VectorXd& q = plan.segments.back().positions.back();
    const Eigen::Isometry3d X_HO =
        problem.robot.pose(problem.robot.frame("grasp"), q).inverse() * plan.X_WO_goal;
    const Eigen::Matrix2Xd& corners = problem.object.outline().vertices();
    double least = 0;
    for (Eigen::Index i = 0; i < corners.cols(); ++i) {
      const Eigen::Vector2d a = corners.col(i), b = corners.col((i + 1) % corners.cols());
      for (int k = 0; k <= 2000; ++k) {
        const Eigen::Vector2d p = a + k / 2000.0 * (b - a);
        const Eigen::Vector3d p_H = X_HO * Eigen::Vector3d(p.x(), p.y(), 0);
        if (std::abs(p_H.x()) <= problem.hand.pad_width / 2) least = std::min(least, p_H.z());
      }
    }
    EXPECT_NEAR(bearing(problem, plan)->depth, -least, 1e-4);
  }
}

TEST(SlideBearing, ItGrowsWithTheEffortLimitAndIsNotKnownWithoutOne) {
  const Plan weak = slide::plan(with_effort("2", 0.1)), strong = slide::plan(with_effort("6", 0.1)),
             unknown = slide::plan(with_effort("", 0.1));
  ASSERT_TRUE(weak && strong && unknown);
  EXPECT_NEAR(*strong.max_mass, 3 * *weak.max_mass, 1e-9);
  EXPECT_FALSE(unknown.max_mass);
}

TEST(SlideBearing, TheArmIsNotPartOfIt) {
  Problem problem = with_effort("2", 0.1);
  const Plan plan = slide::plan(problem);
  ASSERT_TRUE(plan) << plan.reason;
  const std::regex of_arm(" effort=\"(?!2\")[^\"]*\"");
  const std::string urdf = std::regex_replace(problem.robot.urdf(), of_arm, "");
  problem.robot = robot::Robot::from_urdf(urdf, problem.robot.options());
  EXPECT_TRUE(std::isinf(problem.robot.max_effort().maxCoeff()));
  EXPECT_NEAR(bearing(problem, plan)->max_mass, *plan.max_mass, 1e-9);
}

TEST(SlideBearing, AnEffortLimitThatIsAPlaceholderIsUnknown) {
  EXPECT_FALSE(slide::plan(with_effort("1000", 0.1)).max_mass);
}

TEST(SlideBearing, AnObjectTooHeavyForTheFingersIsWarnedOf) {
  Problem problem = with_effort("2", 0.1);
  Plan plan = slide::plan(problem);
  ASSERT_TRUE(plan) << plan.reason;
  const double most = *plan.max_mass;
  EXPECT_GT(most, 0.1);
  EXPECT_TRUE(plan.warnings.empty());
  EXPECT_TRUE(check(problem, plan).empty());

  const auto faults = [&] { return joined(check(problem, plan)); };
  const std::string missing = "the plan lacks this one: the hand may lose the object";
  problem.object = problem.object.with_mass(0.99 * most);
  EXPECT_EQ(faults().find(missing), std::string::npos) << faults();
  problem.object = problem.object.with_mass(1.1 * most);
  EXPECT_NE(faults().find(missing), std::string::npos) << faults();
  problem.object = problem.object.with_mass(0.1);
  plan.max_mass = 0;
  EXPECT_NE(faults().find("max_mass must be above 0"), std::string::npos) << faults();
  plan.max_mass = 1.1 * most;
  EXPECT_NE(faults().find("max_mass must be above 0 and at most what the fingers bear"),
            std::string::npos)
      << faults();
}

TEST(SlideBearing, AnObjectThatIsLeftIsNotBorne) {
  Problem problem = with_effort("2", 0.1);
  problem.X_WO_end = flat(0.6, -0.1, 0.4);
  const Plan plan = slide::plan(problem);
  ASSERT_TRUE(plan) << plan.reason;
  EXPECT_FALSE(plan.max_mass);
}

}  // namespace
}  // namespace graspless::slide
