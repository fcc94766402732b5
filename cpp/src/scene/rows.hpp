// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/geometry/pose.hpp"
#include "graspless/robot/robot.hpp"
#include "graspless/watch.hpp"

/// Steps between the rows of a motion, and conditions that every check() puts on them.
namespace graspless::scene {

constexpr double kRowStep = 0.05;     // largest Robot::step() between planned rows [rad]
constexpr double kReplayStep = 0.01;  // between checked configurations, Robot::step() [rad]
constexpr double kLongestStep = kRowStep + 1e-9;  // between rows, Robot::step() [rad]

/// Number of equal steps in which a straight motion is checked: rows of kRowStep, each divided at
/// `resolution`. check() replays the plan at the same configurations, so that no collision hides
/// between two grids.
inline int replay_steps(double span, double resolution) {
  const double rows = std::max(1.0, std::ceil(span / kRowStep));
  return static_cast<int>(rows * std::max(1.0, std::ceil(span / rows / resolution)));
}

/// Length of such a step [rad].
inline double replay_step(const robot::Robot& robot, const Eigen::VectorXd& from,
                          const Eigen::VectorXd& to, double resolution) {
  const double span = robot.step(from, to);
  if (span == 0) return resolution;
  constexpr double kRounding = 1 + 1e-12;
  return span / replay_steps(span, resolution) * kRounding;
}

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

/// Calls fault(place, what) unless a plan has the robot's joints, segments of these names, and in
/// each of them rows: configurations of the robot, and one object pose for each. Of each segment,
/// only the first wrong row is told.
template <class Plan, class Fault>
void check_shape(const robot::Robot& robot, const Plan& plan, const std::vector<std::string>& names,
                 Fault fault) {
  const std::string wrong = wrong_names(robot, plan.joint_names);
  if (!wrong.empty()) fault("plan", wrong);
  std::vector<std::string> found;
  for (const auto& segment : plan.segments) found.push_back(segment.name);
  if (found != names) {
    std::string listed;
    for (const std::string& name : names) listed += (listed.empty() ? "" : ", ") + name;
    fault("plan", "segments are not " + listed);
  }
  for (const auto& segment : plan.segments) {
    const std::size_t rows = segment.positions.size();
    if (rows == 0 || rows != segment.object_poses.size()) {
      fault(segment.name, "must have rows, and one object pose for each row");
      continue;
    }
    for (std::size_t i = 0; i < rows; ++i) {
      if (robot::is_configuration(robot, segment.positions[i]) &&
          geometry::is_pose(segment.object_poses[i]))
        continue;
      fault(segment.name + " row " + std::to_string(i),
            "has the wrong size, a value that is not finite, or no pose");
      break;
    }
  }
}

/// Calls fault(row, what) for each row that is too far from the row before it or leaves the joint
/// limits, and for the first row if it differs from `before` by more than `same`.
void check_rows(const robot::Robot& robot, Eigen::VectorXd before, double same,
                const std::vector<Eigen::VectorXd>& rows,
                const std::function<void(std::size_t row, const std::string& what)>& fault);

}  // namespace graspless::scene
