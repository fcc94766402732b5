// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Stability at given commanded forces, and the gauge of wrenches.
#include "mechanics/stability/fixed_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "graspless/mechanics/stability_solver.hpp"

#include "mechanics/contacts/wrenches.hpp"
#include "mechanics/lp/conditioning.hpp"

namespace graspless::mechanics {
namespace {

int add_columns(LinearProgram* program, const Matrix6Xd& generators) {
  const auto first = static_cast<int>(program->num_variables());
  for (Eigen::Index j = 0; j < generators.cols(); ++j) program->add_variable(0, kInfinity);
  program->set_block(0, first, generators);
  return first;
}

void set_balance(LinearProgram* program, const Vector6d& value) {
  for (Eigen::Index i = 0; i < 6; ++i) {
    const auto row = static_cast<std::size_t>(i);
    program->row_lower[row] = program->row_upper[row] = value[i];
  }
}

}  // namespace

FixedForces::FixedForces(const ContactSet& set, const std::vector<FingerMode>& modes,
                         const Eigen::VectorXd& commanded_forces) {
  const EnvironmentWrenches environment = wrenches_of_environment(set);
  const std::vector<FingerWrenches> fingers = wrenches_of_fingers(set);
  even_ = balance_conditioning(environment, fingers);
  known_ = even_ * environment.known;
  for (int i = 0; i < 6; ++i) program_.add_row(0, 0);
  int next = add_columns(&program_, even_ * environment.generators);
  for (const Contact& contact : set.contacts) {
    if (contact.mode == ContactMode::slide) {
      sliding_.push_back(next++);
      normal_.push_back(1 / std::hypot(1, contact.friction));
    } else {
      next += set.cone_edges;
    }
  }
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    const FingerWrenches& finger = fingers[i];
    const double f_com = commanded_forces[i];
    const int row = modes[i] == FingerMode::force
                        ? program_.add_row(f_com, f_com)
                        : program_.add_row(-kInfinity, finger.max_normal_force);
    program_.set_block(row, add_columns(&program_, even_ * finger.generators),
                       finger.normal.transpose());
  }
}

double FixedForces::reach(const Vector6d& direction, double enough) const {
  LinearProgram shot = program_;
  set_balance(&shot, -known_);
  shot.set_block(0, shot.add_variable(0, enough, 1), -even_ * direction);
  return std::max(0.0, solve_lp(shot).objective);
}

double FixedForces::stability(const Matrix6Xd& directions) const {
  double least = kInfinity;
  for (Eigen::Index d = 0; d < directions.cols() && least > 0; ++d) {
    least = reach(directions.col(d), least);
  }
  return least;
}

Eigen::VectorXd FixedForces::sliding_forces(const Vector6d& target) const {
  LinearProgram program = program_;
  set_balance(&program, even_ * target - known_);
  for (std::size_t i = 0; i < sliding_.size(); ++i) {
    program.objective[sliding_[i]] = -normal_[i];
  }
  const LpSolution solution = solve_lp(program);
  if (solution.status != LpStatus::optimal) {
    throw std::runtime_error("a wrench within reach could not be balanced");
  }
  Eigen::VectorXd forces(static_cast<Eigen::Index>(sliding_.size()));
  for (std::size_t i = 0; i < sliding_.size(); ++i) {
    forces[i] = normal_[i] * std::max(0.0, solution.x[sliding_[i]]);
  }
  return forces;
}

double gauge(const Matrix6Xd& directions, const Vector6d& wrench) {
  LinearProgram program;
  for (int i = 0; i < 6; ++i) program.add_row(wrench[i], wrench[i]);
  for (Eigen::Index d = 0; d < directions.cols(); ++d) program.add_variable(0, kInfinity, -1);
  program.set_block(0, 0, directions);
  const LpSolution solution = solve_lp(program);
  return solution.status == LpStatus::optimal ? -solution.objective : kInfinity;
}

double largest_gauge(const Matrix6Xd& directions, const std::vector<Vector6d>& wrenches) {
  Vector6d plus, minus;
  for (int i = 0; i < 6; ++i) {
    plus[i] = gauge(directions, Vector6d::Unit(i));
    minus[i] = gauge(directions, -Vector6d::Unit(i));
  }
  // A gauge is at most the sum of the gauges of the parts.
  std::vector<double> at_most;
  for (const Vector6d& w : wrenches) {
    at_most.push_back(plus.dot(w.cwiseMax(0.0)) + minus.dot((-w).cwiseMax(0.0)));
  }
  std::vector<std::size_t> order(wrenches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return at_most[i] > at_most[j]; });
  double largest = 0;
  for (const std::size_t i : order) {
    if (at_most[i] <= largest) break;
    largest = std::max(largest, gauge(directions, wrenches[i]));
  }
  return largest;
}

}  // namespace graspless::mechanics
