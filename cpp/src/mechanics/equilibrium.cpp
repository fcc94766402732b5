// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Nominal forces: among the equilibria that are deep inside their limits, the least.
#include "graspless/mechanics/equilibrium.hpp"

#include <algorithm>

#include <Eigen/LU>

#include "graspless/mechanics/stability_solver.hpp"

#include "mechanics/conditioning.hpp"
#include "mechanics/control.hpp"
#include "mechanics/least_forces.hpp"
#include "mechanics/lp.hpp"

namespace graspless::mechanics {
namespace {

// The optimum of the programme is a vertex, and rarely the only one: rounding would choose between
// forces far apart. So a tenth of its margin is given up, and of what that allows the coefficients
// of least squares are taken: one answer, which follows the contacts continuously.
constexpr double kKept = 0.9;

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
    return first - 1;  // t is no coefficient
  }
  /// The normal force of one finger: f_com, or f_max less t at most.
  void add_normal(int first, const FingerWrenches& finger, bool force, double f_com) {
    const int row =
        force ? lp_.add_row(f_com, f_com) : lp_.add_row(-kInfinity, finger.max_normal_force);
    lp_.set_block(row, first + 1, finger.normal.transpose());
    lp_.set(row, t_, finger.normal.sum() + (force ? 0 : 1));
  }
  /// The coefficients k, or nothing where there are none.
  std::optional<Eigen::VectorXd> solve() {
    lp_.set_block(0, t_, on_t_);
    const LpSolution solution = solve_lp(lp_);
    if (solution.status != LpStatus::optimal) return std::nullopt;
    const double largest = solution.objective, t = kKept * largest;
    if (largest > 0) {  // else there is no room to choose in
      if (const auto least = least_squares(t)) return (*least).array() + t;
    }
    return solution.x.tail(solution.x.size() - 1).array() + largest;
  }

 private:
  /// k' >= 0 of least squares for a t at which the rows can be kept with room to spare.
  std::optional<Eigen::VectorXd> least_squares(double t) const {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(lp_.num_rows(), lp_.num_variables());
    for (const auto& entry : lp_.entries) A(entry.row(), entry.col()) = entry.value();
    LeastForces problem;
    problem.A = A.rightCols(A.cols() - 1);
    problem.upper =
        Eigen::Map<const Eigen::VectorXd>(lp_.row_upper.data(), A.rows()) - t * A.col(0);
    for (const double lower : lp_.row_lower) problem.is_equal.push_back(lower > -kInfinity);
    return least_forces(problem);
  }
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
  const auto solution = interior.solve();
  if (!solution) return std::nullopt;
  const Eigen::VectorXd& k = *solution;
  Equilibrium equilibrium;
  equilibrium.margin = k.size() > 0 ? k.minCoeff() : 0;
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
    const Eigen::VectorXd edges = k.segment(first_finger[i], fingers[i].generators.cols());
    equilibrium.finger_forces_O.col(static_cast<Eigen::Index>(i)) =
        force_of(unscale, fingers[i].generators, edges);
    if (modes[i] == FingerMode::force) continue;
    const double left = fingers[i].max_normal_force - fingers[i].normal.dot(edges);
    equilibrium.margin = std::min(equilibrium.margin, left);
  }
  return equilibrium;
}

}  // namespace graspless::mechanics
