// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/arm.hpp"

namespace graspless::slide {

Arm::Arm(const Problem& problem) : joints_(problem.robot.group(problem.hand.arm)) {
  lower_ = part(problem.robot.lower());
  upper_ = part(problem.robot.upper());
  const Eigen::VectorXd home = part(problem.q_home);
  q_open_ = problem.robot.state(problem.hand.open);
  q_closed_ = problem.robot.state(problem.hand.closed);
  write(home, q_open_);
  write(home, q_closed_);
}

}  // namespace graspless::slide
