// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Nominal forces: the equilibrium that is deepest inside its limits.
#include "graspless/mechanics/equilibrium.hpp"

#include <Eigen/LU>

#include "graspless/mechanics/stability_solver.hpp"

#include "mechanics/conditioning.hpp"
#include "mechanics/control.hpp"
#include "mechanics/lp.hpp"

namespace graspless::mechanics {
namespace {

/// A programme in t and k' >= 0, the coefficients being k = t + k'.
class Interior {
 public:
  Interior(double t_max, const Matrix6d& even, const Vector6d& known)
      : t_(lp_.add_variable(0, t_max, 1)), even_(even) {
    const Vector6d right = -even * known;
    for (int i = 0; i < 6; ++i) lp_.add_row(right[i], right[i]);
  }
  /// k' of these generators; gives the first one's index.
  int add(const Matrix6Xd& generators) {
    const auto first = static_cast<int>(lp_.num_variables());
    for (Eigen::Index j = 0; j < generators.cols(); ++j) lp_.add_variable(0, kInfinity);
    lp_.set_block(0, first, even_ * generators);
    on_t_ += even_ * generators.rowwise().sum();
    return first;
  }
  /// The normal force of one finger: f_com, or f_max less t at most.
  void add_normal(int first, const FingerWrenches& finger, bool force, double f_com) {
    const int row =
        force ? lp_.add_row(f_com, f_com) : lp_.add_row(-kInfinity, finger.max_normal_force);
    lp_.set_block(row, first, finger.normal.transpose());
    lp_.set(row, t_, finger.normal.sum() + (force ? 0 : 1));
  }
  LpSolution solve() {
    lp_.set_block(0, t_, on_t_);
    return solve_lp(lp_);
  }

 private:
  LinearProgram lp_;
  int t_;
  Matrix6d even_;                     // on both sides of the balance
  Vector6d on_t_ = Vector6d::Zero();  // what the balance gains per unit of t
};

/// t grows without bound only where the environment alone can jam: no force that is asked for here
/// is of use beyond this one.
double largest_margin(const ContactSet& set) {
  double sum = set.known_wrench_O.head<3>().norm();
  for (const Finger& finger : set.fingers) sum += finger.max_normal_force;
  return sum;
}

Eigen::Vector3d force_of(const Matrix6d& unscale, const Matrix6Xd& generators,
                         const Eigen::VectorXd& k) {
  return (unscale * (generators * k)).head<3>();
}

}  // namespace

std::optional<Equilibrium> interior_equilibrium(const ContactSet& set,
                                                const std::vector<FingerMode>& modes,
                                                const Eigen::VectorXd& commanded_forces) {
  validate(set);
  validate_modes(set, modes);
  validate_commanded_forces(set, modes, commanded_forces);
  const EnvironmentWrenches environment = environment_wrenches(set);
  std::vector<FingerWrenches> fingers;
  for (int i = 0; i < static_cast<int>(set.fingers.size()); ++i) {
    fingers.push_back(finger_wrenches(set, i));
  }
  Interior interior(largest_margin(set), balance_conditioning(environment, fingers),
                    environment.known);
  const int first_contact = interior.add(environment.generators);
  std::vector<int> first_finger;
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    first_finger.push_back(interior.add(fingers[i].generators));
    const double f_com = commanded_forces[static_cast<Eigen::Index>(i)];
    interior.add_normal(first_finger[i], fingers[i], modes[i] == FingerMode::force, f_com);
  }
  const LpSolution solution = interior.solve();
  if (solution.status != LpStatus::optimal) return std::nullopt;

  Equilibrium equilibrium;
  equilibrium.margin = solution.objective;
  const Eigen::VectorXd k = solution.x.array() + solution.objective;
  const Matrix6d unscale = set.wrench_scale.inverse();
  equilibrium.contact_forces_O.resize(3, static_cast<Eigen::Index>(set.contacts.size()));
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    const Eigen::Index edges = set.contacts[i].mode == ContactMode::stick ? set.cone_edges : 1;
    equilibrium.contact_forces_O.col(static_cast<Eigen::Index>(i)) =
        force_of(unscale, environment.generators.middleCols(next, edges),
                 k.segment(first_contact + next, edges));
    next += edges;
  }
  equilibrium.finger_forces_O.resize(3, static_cast<Eigen::Index>(fingers.size()));
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    equilibrium.finger_forces_O.col(static_cast<Eigen::Index>(i)) = force_of(
        unscale, fingers[i].generators, k.segment(first_finger[i], fingers[i].generators.cols()));
  }
  return equilibrium;
}

}  // namespace graspless::mechanics
