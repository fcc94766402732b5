// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/clasp/clasp.hpp"

#include "clasp/tasks.hpp"

namespace graspless::clasp {

/// TS-CONTROL, Algorithm 4: arm and hand one step towards a point of task space.
///
/// Read as follows: M_arm and M_hand let the arm do what position and alignment ask and the hand
/// what the linking asks, before the pseudo-inverses, so that no part of a motion is asked of a
/// joint that will not do it. Pseudo-inverses are damped. A curve that is not linked asks nothing.
/// The direction to the target counts less the nearer the target is. The hand waits on its way
/// while it is misaligned. A joint that would leave its limits is left out and
/// the others asked anew.
class Controller {
 public:
  /// `tasks` must outlive the controller.
  Controller(Tasks& tasks, const robot::Robot& robot, const Hand& hand, const Options& options);

  /// Writes the configuration one step from q towards x_target, within the joint limits, no joint
  /// moving more than `max_step`; false when the step would be shorter than 2e-4 [rad] in every
  /// joint. Projects q anew unless it is the one projected last. Allocates nothing.
  bool step(const Eigen::VectorXd& q, const TaskPoint& x_target, double max_step,
            Eigen::VectorXd& q_new);

 private:
  /// What is asked (u), how the joints that may bring it about (J), and the pseudo-inverse
  /// J' (J J' + damping^2)^-1.
  struct Task {
    double damping;
    Eigen::MatrixXd J, JJ;
    Eigen::VectorXd u, y;
    Eigen::LLT<Eigen::MatrixXd> factor;
  };

  Task make_task(double damping, int rows) const;
  static void factorise(Task& task);
  static void add_inverse(Task& task, const Eigen::VectorXd& u, Eigen::VectorXd& q_dot);
  void solve();
  bool leave_out_blocked(const Eigen::VectorXd& q);
  double gain(double distance) const;

  Tasks& tasks_;
  Options options_;
  Eigen::VectorXd lower_, upper_;
  Eigen::RowVectorXd arm_gains_, hand_gains_;  // diagonals of M_arm and M_hand
  Task position_, alignment_, linking_;
  double blend_ = 0;
  Eigen::VectorXd q_dot_arm_, q_dot_hand_, q_dot_;
};

}  // namespace graspless::clasp
