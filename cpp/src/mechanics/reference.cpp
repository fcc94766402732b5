// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Problems (5) and (6) as the paper writes them: slow, plain, and what the fast engine is held to.
#include "mechanics/reference.hpp"

#include <algorithm>

#include "graspless/mechanics/stability_solver.hpp"

#include "mechanics/conditioning.hpp"
#include "mechanics/fixed_forces.hpp"
#include "mechanics/lp.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kBinding = 1e-9;

/// The matrices of Section 2.2 that (5) and (6) share, times R^1/2.
struct Matrices {
  Matrices(const ContactSet& set, const std::vector<FingerMode>& control_modes)
      : environment(environment_wrenches(set)), modes(control_modes) {
    for (int i = 0; i < static_cast<int>(set.fingers.size()); ++i) {
      fingers.push_back(finger_wrenches(set, i));
    }
    even = balance_conditioning(environment, fingers);
  }
  bool is_force(std::size_t i) const { return modes[i] == FingerMode::force; }

  EnvironmentWrenches environment;      // R^1/2 W_env C_env, R^1/2 Q_known
  std::vector<FingerWrenches> fingers;  // R^1/2 W_rob C_rob and N_rob' C_rob, a finger each
  Matrix6d even;                        // on both sides of each balance
  const std::vector<FingerMode>& modes;
};

/// A column k >= 0 for each generator: the first one's index.
int add_coefficients(LinearProgram* lp, const Eigen::MatrixXd& generators, double upper,
                     double objective) {
  const auto first = static_cast<int>(lp->num_variables());
  for (Eigen::Index j = 0; j < generators.cols(); ++j) lp->add_variable(0, upper, objective);
  return first;
}

int add_balance_rows(LinearProgram* lp, const Vector6d& value) {
  const auto first = static_cast<int>(lp->num_rows());
  for (int i = 0; i < 6; ++i) lp->add_row(value[i], value[i]);
  return first;
}

/// The rows of (6) that belong to one direction l_i, with k_env i and k_rob i.
void add_direction(LinearProgram* lp, const Matrices& m, int z, const std::vector<int>& f_com,
                   const Vector6d& l_i) {
  // z l_i = R^1/2 (Q_known + W_env C_env k_env i + W_rob C_rob k_rob i)
  const int balance = add_balance_rows(lp, -m.even * m.environment.known);
  lp->set_block(balance, z, -m.even * l_i);
  const int k_env = add_coefficients(lp, m.environment.generators, kInfinity, 0);
  lp->set_block(balance, k_env, m.even * m.environment.generators);
  for (std::size_t i = 0; i < m.fingers.size(); ++i) {
    const FingerWrenches& finger = m.fingers[i];
    const int k_rob = add_coefficients(lp, finger.generators, kInfinity, 0);
    lp->set_block(balance, k_rob, m.even * finger.generators);
    // N_rob' C_rob k_rob i <= f_max; N_rob' A_force C_rob k_rob i = f_com, where f_com <= f_max
    // already stands for the limit.
    const int normal =
        m.is_force(i) ? lp->add_row(0, 0) : lp->add_row(-kInfinity, finger.max_normal_force);
    lp->set_block(normal, k_rob, finger.normal.transpose());
    if (m.is_force(i)) lp->set(normal, f_com[i], -1);
  }
}

/// Directions whose targets cannot be moved further with these commanded forces.
std::vector<int> binding(const ContactSet& set, const std::vector<FingerMode>& modes,
                         const Matrix6Xd& directions, const Stability& stability) {
  const FixedForces balance(set, modes, stability.commanded_forces);
  const double beyond = stability.z + kBinding * std::max(1.0, stability.z);
  std::vector<int> found;
  for (Eigen::Index d = 0; d < directions.cols(); ++d) {
    if (balance.reach(directions.col(d), 2 * beyond) < beyond) {
      found.push_back(static_cast<int>(d));
    }
  }
  return found;
}

}  // namespace

Stability max_stability_reference(const ContactSet& set, const std::vector<FingerMode>& modes,
                                  const Matrix6Xd& directions) {
  const Matrices m(set, modes);
  LinearProgram lp;
  const int z = lp.add_variable(0, kInfinity, 1);  // maximise z  (6)
  std::vector<int> f_com(m.fingers.size(), -1);
  for (std::size_t i = 0; i < m.fingers.size(); ++i) {
    if (m.is_force(i)) f_com[i] = lp.add_variable(0, m.fingers[i].max_normal_force);
  }
  for (Eigen::Index d = 0; d < directions.cols(); ++d) {
    add_direction(&lp, m, z, f_com, directions.col(d));
  }
  const LpSolution solution = solve_lp(lp);

  Stability stability;
  stability.z = solution.objective;
  stability.commanded_forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(modes.size()));
  if (solution.status != LpStatus::optimal) return stability;
  stability.z = std::max(0.0, solution.objective);
  for (std::size_t i = 0; i < f_com.size(); ++i) {
    if (f_com[i] < 0) continue;
    stability.commanded_forces[static_cast<Eigen::Index>(i)] =
        std::clamp(solution.x[f_com[i]], 0.0, m.fingers[i].max_normal_force);
  }
  if (stability.z > 0) {
    stability.binding_directions = binding(set, modes, directions, stability);
  }
  return stability;
}

bool internal_force_is_bounded_reference(const ContactSet& set,
                                         const std::vector<FingerMode>& modes) {
  const Matrices m(set, modes);
  const auto of = [](const auto& wrenches) -> const Matrix6Xd& {
    return wrenches.jam_generators.cols() > 0 ? wrenches.jam_generators : wrenches.generators;
  };
  // maximise b_env' k_env + b_rob' k_rob
  // subject to W_env C_env k_env + W_rob A_pos C_rob k_rob = 0, k_env >= 0, k_rob >= 0  (5)
  // A feasible k may be scaled, so that an unbounded objective shows as one of 1 or more under
  // k <= 1, and a bounded one as 0: an optimum either way, whose residuals can be checked.
  LinearProgram lp;
  const int balance = add_balance_rows(&lp, Vector6d::Zero());
  lp.set_block(balance, add_coefficients(&lp, of(m.environment), 1, 1), of(m.environment));
  for (std::size_t i = 0; i < m.fingers.size(); ++i) {
    if (m.is_force(i)) continue;
    lp.set_block(balance, add_coefficients(&lp, of(m.fingers[i]), 1, 1), of(m.fingers[i]));
  }
  return solve_lp(lp).objective < 0.5;
}

}  // namespace graspless::mechanics
