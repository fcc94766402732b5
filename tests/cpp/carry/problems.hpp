// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "graspless/carry/carry.hpp"
#include "graspless/robot/ik.hpp"

#include "complaint.hpp"
#include "robot/robots.hpp"

/// A box in the hands of the WAM and of the KR5, as the tests of carrying need them.
namespace graspless::carry {

using robot::kr5, robot::wam;

inline Obstacle box(const std::string& name, const Eigen::Vector3d& size,
                    const Eigen::Isometry3d& X_WB) {
  return {name, {{geometry::Box{size}, Eigen::Isometry3d::Identity()}}, X_WB};
}

inline Eigen::Isometry3d moved(const Eigen::Isometry3d& X, const Eigen::Vector3d& by_W) {
  return Eigen::Translation3d(by_W) * X;
}

/// A box 10 cm long that the open hand holds at its middle, to be taken by `by_W`.
inline Problem held_box(const robot::Robot& robot, const Eigen::VectorXd& q,
                        const Eigen::Vector3d& by_W) {
  const Eigen::Isometry3d X_WO = robot.pose(robot.frame("grasp"), q);
  return {robot, "arm", "grasp", box("box", {0.10, 0.03, 0.03}, X_WO), moved(X_WO, by_W),
          {},    {},    q};
}

inline Problem held_box(const robot::Robot& robot, const Eigen::Vector3d& by_W) {
  return held_box(robot, robot.state("home"), by_W);
}

constexpr double kTop = 0.05, kHalf = 0.015;  // of the table, and of the bar [m]

/// A pose of the bar, held from above: X_WO = X_WH.
inline Eigen::Isometry3d held_at(double x, double y, double z, double yaw = 0) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() << x, y, z;
  X.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
               Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  return X;
}

inline Eigen::Isometry3d on_table(double x, double y, double yaw = 0) {
  return held_at(x, y, kTop + kHalf, yaw);
}

/// A bar that a hand holds from above over a table, to be put down at some places.
inline Problem over_table(const robot::Robot& robot, std::vector<Eigen::Isometry3d> places) {
  const int frame = robot.frame("grasp");
  std::mt19937_64 rng(1);
  const auto all = robot::Ik(robot, frame, robot.group("arm"))
                       .solve_all(held_at(0.55, 0.1, 0.3), robot.state("home"), rng);
  EXPECT_FALSE(all.empty());
  Problem problem = held_box(robot, all.front(), {0, 0, 0.1});
  problem.q_start[robot.joint("left_finger_joint")] = 0.15;
  problem.obstacles = {
      box("table", {0.7, 0.7, kTop}, moved(Eigen::Isometry3d::Identity(), {0.6, 0, kTop / 2}))};
  problem.places =
      Places{std::move(places), "table", Eigen::Vector3d::UnitZ(), robot.state("open")};
  return problem;
}

inline std::string faults_of(const Problem& problem, const Plan& plan,
                             const Options& options = {}) {
  return joined(check(problem, plan, options));
}

inline Segment& segment(Plan& plan, const std::string& name) {
  return *std::find_if(plan.segments.begin(), plan.segments.end(),
                       [&](const Segment& other) { return other.name == name; });
}

}  // namespace graspless::carry
