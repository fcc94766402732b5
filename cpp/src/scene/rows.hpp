// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/robot/robot.hpp"
#include "graspless/watch.hpp"

/// Conditions that every check() puts on the rows of a motion.
namespace graspless::scene {

constexpr double kReplayStep = 0.01;          // between checked configurations, Robot::step() [rad]
constexpr double kLongestStep = 0.05 + 1e-9;  // between rows, Robot::step() [rad]

/// Calls visit(row, q) at steps of kReplayStep along the rows; `row` is the index of the row that
/// the step leads to. Of a step longer than kLongestStep, which check_rows() reports, it visits
/// few.
template <typename Visit>
void replay_rows(const robot::Robot& robot, const std::vector<Eigen::VectorXd>& rows, Visit visit) {
  visit(std::size_t{0}, rows[0]);
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const Eigen::VectorXd& from = rows[row - 1];
    const Eigen::VectorXd step = rows[row] - from;
    const double length = std::min(robot.step(from, rows[row]), kLongestStep);
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / kReplayStep)));
    for (int i = 1; i <= pieces; ++i) {
      poll();
      visit(row, from + step * i / pieces);
    }
  }
}

/// True if two poses agree in position [m] and attitude [rad] within `tolerance`.
bool is_same(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double tolerance);

/// What is wrong with the joint names of a plan; empty if they are the robot's.
std::string wrong_names(const robot::Robot& robot, const std::vector<std::string>& names);

/// Calls fault(row, what) for each row that is too far from the row before it or leaves the joint
/// limits, and for the first row if it differs from `before` by more than `same`.
void check_rows(const robot::Robot& robot, Eigen::VectorXd before, double same,
                const std::vector<Eigen::VectorXd>& rows,
                const std::function<void(std::size_t row, const std::string& what)>& fault);

}  // namespace graspless::scene
