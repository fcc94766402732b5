// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "pinch/check_contacts.hpp"

namespace graspless::pinch {

using Eigen::Vector3d;

namespace {

constexpr double kMotorShare = 0.5;  // of the effort limit of a joint that grips
constexpr double kStill = 1e-3;      // of the fingers' motion per unit of a joint [m/rad or 1]

/// The link of one side of the hand that is farthest along a direction.
struct Foremost {
  int link = -1;
  double extent = -std::numeric_limits<double>::infinity();  // from the origin of W [m]
};

Foremost foremost(const Problem& problem, const robot::Poses& X_WL, const Vector3d& d_W,
                  bool sliding) {
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  Foremost found;
  for (const robot::LinkShape& shape : problem.robot.shapes()) {
    const auto link = static_cast<std::size_t>(shape.link);
    const std::string& name = problem.robot.frame_names()[link];
    if (!has(problem.hand.fingers, name) || has(problem.hand.sliding_finger, name) != sliding)
      continue;
    const double extent = d_W.dot(X_WL[link].translation()) +
                          geometry::extent(shape.placed, X_WL[link].linear().transpose() * d_W);
    if (extent > found.extent) found = {shape.link, extent};
  }
  return found;
}

}  // namespace

std::optional<double> finger_force(const Problem& problem, const Plan& plan,
                                   const Options& options) {
  if (options.grip_force) return options.grip_force;
  const robot::Robot& robot = problem.robot;
  robot::Poses X_WL;
  robot.forward(plan.segments.back().positions.back(), X_WL);
  const Eigen::Matrix3Xd p_W = problem.X_WO_start * plan.contacts_O;
  const Vector3d across = (p_W.col(1) - p_W.col(0)).normalized();
  const auto reach = [&](const Vector3d& d_W) { return foremost(problem, X_WL, d_W, true).extent; };
  const bool is_second = reach(across) - reach(-across) > across.dot(p_W.col(0) + p_W.col(1));
  Eigen::RowVectorXd closing = Eigen::RowVectorXd::Zero(robot.dof());  // [m/rad or 1]
  for (const int side : {0, 1}) {
    const Vector3d inward = side == 0 ? across : Vector3d(-across);
    const int link = foremost(problem, X_WL, inward, (side == 1) == is_second).link;
    const Vector3d arm = p_W.col(side) - X_WL[static_cast<std::size_t>(link)].translation();
    Eigen::Matrix<double, 6, Eigen::Dynamic> J;
    robot.jacobian(link, X_WL, J);
    closing += inward.transpose() * J.topRows<3>();
    closing += arm.cross(inward).transpose() * J.bottomRows<3>();  // inward . (w x arm)
  }
  for (const int joint : robot.group(problem.hand.arm)) closing[joint] = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index j = 0; j < closing.size(); ++j) {
    const double rate = std::abs(closing[j]), limit = robot.max_effort()[j];
    if (rate < kStill) continue;
    if (!std::isfinite(limit)) return std::nullopt;
    least = std::min(least, kMotorShare * limit / rate);
  }
  return std::isfinite(least) ? least : 0;
}

}  // namespace graspless::pinch
