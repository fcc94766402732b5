// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/clasp/clasp.hpp"

#include "clasp/tasks.hpp"

namespace graspless::clasp {

/// TS-CONTROL, Algorithm 4: arm and hand one step towards a point of task space.
class Controller {
 public:
  /// `tasks` must outlive the controller.
  Controller(Tasks& tasks, const robot::Robot& robot, const Hand& hand, const Options& options);

  /// Writes the configuration one step from q towards x_target, within the joint limits, no joint
  /// moving more than `max_step`; false when the step would be shorter than 2e-4 [rad] in every
  /// joint. Projects q anew.
  bool step(const Eigen::VectorXd& q, const TaskPoint& x_target, double max_step,
            Eigen::VectorXd& q_new);

 private:
  Tasks& tasks_;
  robot::Robot robot_;
  Options options_;
};

}  // namespace graspless::clasp
