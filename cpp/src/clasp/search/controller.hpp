// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/clasp/clasp.hpp"

#include "clasp/search/task_space.hpp"

namespace graspless::clasp {

/// TS-CONTROL, Algorithm 4: moves arm and hand one step towards a point of task space.
///
/// Choices that the paper leaves open:
/// - M_arm and M_hand select the arm for position and alignment, and the hand for linking. They are
///   applied before the pseudo-inverses, so that no motion is assigned to a joint that is masked.
/// - Pseudo-inverses are damped.
/// - A curve that is not linked has no linking error.
/// - The direction to the target counts less near the target.
/// - The hand slows down while it is misaligned (kPatience).
/// - A joint at its limit is excluded, and the step is solved again for the others.
class Controller {
 public:
  /// `task_space` must outlive the controller.
  Controller(TaskSpace& task_space, const robot::Robot& robot, const Hand& hand,
             const Options& options);

  /// Computes the configuration one step from q towards x_target, within the joint limits. No joint
  /// moves more than `max_step`, Robot::step() [rad]. Returns false if no joint would move by 2e-4
  /// rad. Projects q unless it was projected last. Allocates no memory. `is_aligned` is false for a
  /// step that need not turn the hand to the loop.
  bool step(const Eigen::VectorXd& q, const TaskPoint& x_target, double max_step,
            Eigen::VectorXd& q_new, bool is_aligned = true);

 private:
  /// Error u and Jacobian J of a task, with the damped pseudo-inverse J' (J J' + damping^2)^-1.
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
  bool exclude_blocked(const Eigen::VectorXd& q);
  double gain(double distance) const;

  TaskSpace& task_space_;
  Options options_;
  Eigen::VectorXd lower_, upper_, weights_;
  // Diagonals of M_arm and M_hand. They convert to the units of Robot::step(), in which a step is
  // solved: metres and radians would not weigh alike.
  Eigen::RowVectorXd arm_gains_, hand_gains_;
  Task position_, alignment_, linking_;
  double blend_ = 0;
  Eigen::VectorXd q_dot_arm_, q_dot_hand_, q_dot_;  // in the units of Robot::step()
};

}  // namespace graspless::clasp
