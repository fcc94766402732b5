// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// TS-CONTROL, Algorithm 4 of Stork 2013. Numbers in the margin are its lines.
#include "clasp/search/controller.hpp"

#include <cmath>

namespace graspless::clasp {

using Eigen::VectorXd;

namespace {

// Parameters of Algorithm 4. They balance the three tasks against each other: nobody tunes one of
// them alone, and no object or hand so far needed other values.
constexpr double kTimeStep = 0.5;         // Delta_t
constexpr double kBlendDistance = 0.02;   // where GAIN is a half [m]
constexpr double kBlendSlope = 120;       // of GAIN there [1/m]
constexpr double kPositionDamping = 0.2;  // of the pseudo-inverses [m]
constexpr double kAlignmentDamping = 0.1;
constexpr double kLinkingDamping = 0.02;
// Slows the hand down while it is misaligned, because a hand that arrives so collides. The paper
// has no such term (0).
constexpr double kPatience = 20;

constexpr double kMinStep = 2e-4;  // shorter steps make no node, Robot::step() [rad]
constexpr double kAtLimit = 1e-9;  // distance from a limit that counts as reached [rad]
constexpr int kMaxRounds = 4;      // of excluding joints at their limits

Eigen::RowVectorXd gains_of(const robot::Robot& robot, const std::string& group) {
  Eigen::RowVectorXd gains = Eigen::RowVectorXd::Zero(robot.dof());
  for (const int joint : robot.group(group)) gains[joint] = 1 / robot.step_weights()[joint];
  return gains;
}

}  // namespace

Controller::Controller(TaskSpace& task_space, const robot::Robot& robot, const Hand& hand,
                       const Options& options)
    : task_space_(task_space),
      options_(options),
      lower_(robot.lower()),
      upper_(robot.upper()),
      weights_(robot.step_weights()),
      arm_gains_(gains_of(robot, hand.arm)),
      hand_gains_(gains_of(robot, hand.hand)),
      position_(make_task(kPositionDamping, 3)),
      alignment_(make_task(kAlignmentDamping, 2)),
      linking_(make_task(kLinkingDamping, task_space.kinematics().num_curves())),
      q_dot_arm_(robot.dof()),
      q_dot_hand_(robot.dof()),
      q_dot_(robot.dof()) {}

bool Controller::step(const VectorXd& q, const TaskPoint& x_target, double max_step,
                      VectorXd& q_new, bool is_aligned) {
  task_space_.project(q);
  position_.u = x_target.head<3>() - task_space_.position();           // 1, 2
  task_space_.position_jacobian(position_.J);                          // 3
  alignment_.u = Eigen::Vector2d::Ones() - task_space_.alignment();    // 4, 5
  task_space_.alignment_jacobian(alignment_.J);                        // 6
  linking_.u = x_target[3] - task_space_.linking_of_curves().array();  // 7, 8
  task_space_.linking_jacobian(linking_.J);                            // 9
  const double fade = 1 / (1 + std::pow(kBlendDistance / task_space_.target_distance(), 2));
  alignment_.u[1] *= fade;
  alignment_.J.row(1) *= fade;
  if (options_.attract) task_space_.attract(linking_.u, linking_.J);
  position_.J.array().rowwise() *= arm_gains_.array();
  alignment_.J.array().rowwise() *= arm_gains_.array();
  linking_.J.array().rowwise() *= hand_gains_.array();
  blend_ = gain(position_.u.norm());  // 12
  if (!is_aligned) {
    alignment_.u.setZero();
    alignment_.J.setZero();
  }
  const double misalignment = alignment_.u.maxCoeff();
  position_.u /= 1 + kPatience * misalignment * misalignment;
  solve();  // 10, 11, 13, 14
  for (int round = 1; round < kMaxRounds && exclude_blocked(q); ++round) solve();
  q_dot_ *= kTimeStep;  // 15
  const double longest = q_dot_.cwiseAbs().maxCoeff();
  if (longest > max_step) q_dot_ *= max_step / longest;
  q_new = (q + q_dot_.cwiseQuotient(weights_)).cwiseMax(lower_).cwiseMin(upper_);
  return (q_new - q).cwiseProduct(weights_).cwiseAbs().maxCoeff() >= kMinStep;
}

/// GAIN of line 12: 1 far from the target, 0 near it.
double Controller::gain(double distance) const {
  return 1 / (1 + std::exp(-kBlendSlope * (distance - kBlendDistance)));
}

void Controller::solve() {
  factorise(position_);
  factorise(alignment_);
  factorise(linking_);
  q_dot_arm_.setZero();
  add_inverse(alignment_, alignment_.u, q_dot_arm_);  // 10
  position_.y.noalias() = position_.u - position_.J * q_dot_arm_;
  add_inverse(position_, position_.y, q_dot_arm_);
  q_dot_hand_.setZero();
  add_inverse(linking_, linking_.u, q_dot_hand_);  // 11
  // The arm moves the hand as a whole, J_vlink M_arm = 0. So the null-space projection in line 14
  // does not change the arm's motion.
  q_dot_ = q_dot_arm_ + (1 - blend_) * q_dot_hand_;  // 13, 14
}

/// Excludes joints that are at a limit and would move beyond it. Returns false if there are none.
bool Controller::exclude_blocked(const VectorXd& q) {
  bool any = false;
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const bool blocked = (q_dot_[j] > 0 && q[j] >= upper_[j] - kAtLimit) ||
                         (q_dot_[j] < 0 && q[j] <= lower_[j] + kAtLimit);
    if (!blocked) continue;
    any = true;
    for (Task* task : {&position_, &alignment_, &linking_}) task->J.col(j).setZero();
  }
  return any;
}

Controller::Task Controller::make_task(double damping, int rows) const {
  Task task;
  task.damping = damping;
  task.J.setZero(rows, lower_.size());
  task.JJ.setIdentity(rows, rows);
  task.u.setZero(rows);
  task.y.setZero(rows);
  task.factor.compute(task.JJ);
  return task;
}

void Controller::factorise(Task& task) {
  task.JJ.noalias() = task.J * task.J.transpose();
  task.JJ.diagonal().array() += task.damping * task.damping;
  task.factor.compute(task.JJ);
}

/// q_dot += J' (J J' + damping^2)^-1 u. `u` may be task.y.
void Controller::add_inverse(Task& task, const VectorXd& u, VectorXd& q_dot) {
  task.y = u;
  task.factor.solveInPlace(task.y);
  q_dot.noalias() += task.J.transpose() * task.y;
}

}  // namespace graspless::clasp
