// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/robot/robot.hpp"

namespace graspless::robot {

/// Links from the first that one of the joints moves, whose origin is on that joint, to `link`;
/// empty if none moves it. `q` is any configuration within the limits.
std::vector<int> moved_links(const Robot& robot, const std::vector<int>& joints, int link,
                             const Eigen::VectorXd& q);

}  // namespace graspless::robot
