// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "robot/robots.hpp"

namespace graspless::scene {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;
using robot::Robot;

constexpr double kRadius = 0.1;

Carrier carrier(int link) { return {link, {Eigen::Vector3d::Zero(), kRadius}}; }

VectorXd random_configuration(const Robot& robot, std::mt19937_64& rng) {
  VectorXd q(robot.dof());
  for (int i = 0; i < q.size(); ++i) {
    q[i] = std::uniform_real_distribution<double>(robot.lower()[i], robot.upper()[i])(rng);
  }
  return q;
}

double distance(const Matrix3Xd& a, const Matrix3Xd& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& point : a.colwise()) {
    least = std::min(least, (b.colwise() - point).colwise().norm().minCoeff());
  }
  return least;
}

TEST(RelativeReach, BoundsTheChangeOfEveryDistance) {
  std::mt19937_64 rng(11);
  for (const Robot& robot : {robot::wam(), robot::kr5(), robot::oddity()}) {
    const auto links = static_cast<int>(robot.frame_names().size());
    for (int sample = 0; sample < 2000; ++sample) {
      const int a = std::uniform_int_distribution<int>(0, links - 1)(rng);
      const int b = std::uniform_int_distribution<int>(0, links - 1)(rng);
      Matrix3Xd p_A = Matrix3Xd::Random(3, 6), p_B = Matrix3Xd::Random(3, 6);
      p_A.colwise().normalize();
      p_B.colwise().normalize();
      const VectorXd q1 = random_configuration(robot, rng);
      const VectorXd q2 =
          q1 + (sample % 2 == 0 ? 1 : 0.01) * (random_configuration(robot, rng) - q1);
      const auto apart = [&](const VectorXd& q) {
        return distance(robot.pose(a, q) * (kRadius * p_A), robot.pose(b, q) * (kRadius * p_B));
      };
      const VectorXd bound = relative_reach(robot, carrier(a), carrier(b), false);
      EXPECT_LE(std::abs(apart(q2) - apart(q1)), bound.dot((q2 - q1).cwiseAbs()) + 1e-12)
          << robot.frame_names()[a] << " " << robot.frame_names()[b];
    }
  }
}

TEST(RelativeReach, TurnsTheNearerBody) {
  const Robot arm = Robot::from_urdf(R"(
<robot name="arm"><link name="base"/><link name="upper"/><link name="lower"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
    <origin xyz="0 0 5"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <joint name="elbow" type="revolute"><parent link="upper"/><child link="lower"/>
    <origin xyz="1 0 0"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
</robot>)",
                                     {});
  const Carrier base = carrier(arm.frame("base")), lower = carrier(arm.frame("lower"));
  const VectorXd bound = relative_reach(arm, base, lower, false);
  EXPECT_NEAR(bound[0], kRadius, 1e-12);  // of the base about the shoulder
  EXPECT_NEAR(bound[1], kRadius, 1e-12);  // of the lower link about the elbow
  const VectorXd in_world = relative_reach(arm, Carrier{}, lower, false);
  EXPECT_NEAR(in_world[0], 1 + kRadius, 1e-12);
}

TEST(RelativeReach, KnowsAxesOfAnyDirection) {
  const Robot arm = Robot::from_urdf(R"(
<robot name="arm"><link name="base"/><link name="upper"/><link name="lower"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <joint name="elbow" type="revolute"><parent link="upper"/><child link="lower"/>
    <origin xyz="1 0 0"/><axis xyz="0.6 0.8 0"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
</robot>)",
                                     {});
  const Carrier lower{arm.frame("lower"), {{1.2, 1.6, 0}, kRadius}};  // on the elbow's axis
  const VectorXd bound = relative_reach(arm, Carrier{}, lower, true);
  EXPECT_NEAR(bound[0], std::hypot(2.2, 1.6) + kRadius, 1e-12);
  EXPECT_NEAR(bound[1], kRadius, 1e-12);
  const VectorXd back = relative_reach(arm, carrier(arm.frame("base")), lower, false);
  EXPECT_GE(back[1], kRadius);
}

TEST(FrameRates, BoundTurnAndCurvature) {
  std::mt19937_64 rng(5);
  for (const Robot& robot : {robot::wam(), robot::kr5(), robot::oddity()}) {
    const auto links = static_cast<int>(robot.frame_names().size());
    for (int sample = 0; sample < 1000; ++sample) {
      const int link = std::uniform_int_distribution<int>(0, links - 1)(rng);
      const Eigen::Vector3d p_L = 0.1 * Eigen::Vector3d::Random();
      const VectorXd q = random_configuration(robot, rng);
      const VectorXd step = 0.1 * (random_configuration(robot, rng) - q);
      const FrameRates rates = frame_rates(robot, link, step, p_L);
      constexpr double h = 1e-3;
      const Eigen::Isometry3d X[] = {robot.pose(link, q - h * step), robot.pose(link, q),
                                     robot.pose(link, q + h * step)};
      const Eigen::Vector3d bend = (X[0] * p_L - 2 * (X[1] * p_L) + X[2] * p_L) / (h * h);
      EXPECT_LE(bend.norm(), rates.curvature * (1 + 1e-3) + 1e-8)
          << robot.frame_names()[link] << ", q " << q.transpose() << ", step " << step.transpose();
      const Eigen::Matrix3d turn = X[0].linear().transpose() * X[2].linear();
      EXPECT_LE(Eigen::AngleAxisd(turn).angle() / (2 * h), rates.turn * (1 + 1e-3) + 1e-6);
      const Eigen::Matrix3d bent = (X[0].linear() - 2 * X[1].linear() + X[2].linear()) / (h * h);
      EXPECT_LE(bent.colwise().norm().maxCoeff(), rates.turn * rates.turn * (1 + 1e-3) + 1e-8);
    }
  }
}

}  // namespace
}  // namespace graspless::scene
