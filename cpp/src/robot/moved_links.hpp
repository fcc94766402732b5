// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/robot/robot.hpp"

namespace graspless::robot {

/// Links from the first that one of the joints moves, whose origin is on that joint, to `link`;
/// empty if none moves it. `q` is any configuration within the limits.
std::vector<int> moved_links(const Robot& robot, const std::vector<int>& joints, int link,
                             const Eigen::VectorXd& q);

/// How far an arm gets.
struct Span {
  int base;                ///< the first link that its joints move
  Eigen::Vector3d base_W;  ///< origin of that link [m]
  double most;             ///< largest distance of the frame from there [m]
};

/// Span of a frame on an arm at q. Nothing for an arm with sliding joints.
std::optional<Span> span_of(const Robot& robot, const std::vector<int>& arm, int frame,
                            const Eigen::VectorXd& q);

/// Says that `what`, `away` from the base [m], is farther than `frame` gets.
std::string beyond(const Robot& robot, const Span& span, const std::string& frame,
                   const std::string& what, double away);

}  // namespace graspless::robot
