// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/stability/reference.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/SVD>

#include "mechanics/contacts/wrenches.hpp"
#include "mechanics/lp/program.hpp"
#include "mechanics/stability/exact_wrenches.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kBinding = 1e-9;
constexpr double kNoWeight = 1e-12;      // weight of a generator that counts as none
constexpr double kEvenRows = 1e-3;       // ratio of singular values that GLPK handles well
constexpr double kDependentRow = 1e-13;  // ratio below which rows are dependent
constexpr double kUnbalanced = 1e-12;    // wrench, relative to the largest, that may be rounding

bool is_forced(ForceMask force, std::size_t finger) { return (force >> finger & 1U) != 0; }

/// Factor that makes the rows of a balance equally strong. Otherwise a wrench that contacts hardly
/// resist, as with points nearly on a line, would be lost in GLPK's tolerance. Has one row for each
/// independent row of the balance; the identity if there is no need.
struct EvenRows {
  explicit EvenRows(const Matrix6Xd& generators) : matrix(Matrix6d::Identity()) {
    if (generators.cols() == 0) return;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(generators, Eigen::ComputeFullU);
    const Eigen::VectorXd& sizes = svd.singularValues();
    rank = (sizes.array() > kDependentRow * sizes[0]).count();
    is_identity = rank == 0 || sizes[rank - 1] > kEvenRows * sizes[0];
    if (is_identity) return;
    matrix = (sizes[0] / sizes.head(rank).array()).matrix().asDiagonal() *
             svd.matrixU().leftCols(rank).transpose();
  }
  Eigen::MatrixXd matrix;
  Eigen::Index rank = 0;
  bool is_identity = true;
};

Matrix6Xd side_by_side(const std::vector<const Matrix6Xd*>& parts) {
  Eigen::Index columns = 0;
  for (const Matrix6Xd* part : parts) columns += part->cols();
  Matrix6Xd all(6, columns);
  columns = 0;
  for (const Matrix6Xd* part : parts) {
    all.middleCols(columns, part->cols()) = *part;
    columns += part->cols();
  }
  return all;
}

/// Adds a variable k in [0, upper] for each generator. Returns the index of the first one.
int add_coefficients(LinearProgram* lp, const Eigen::MatrixXd& generators, double upper,
                     double objective) {
  const auto first = static_cast<int>(lp->num_variables());
  for (Eigen::Index j = 0; j < generators.cols(); ++j) lp->add_variable(0, upper, objective);
  return first;
}

/// Returns true if contacts can balance any wrench: the generators span the space, and some
/// combination of all of them, each with a positive weight, cancels.
bool balances_anything(const Eigen::MatrixXd& environment) {
  if (EvenRows(environment).rank < 6) return false;
  LinearProgram lp;
  const int row = static_cast<int>(lp.num_rows());
  for (Eigen::Index i = 0; i < environment.rows(); ++i) lp.add_row(0, 0);
  const int least = lp.add_variable(0, 1, 1);
  lp.set_block(row, add_coefficients(&lp, environment, 1, 0), environment);
  for (int j = 0; j < static_cast<int>(environment.cols()); ++j) {
    const int above = lp.add_row(0, kInfinity);  // k_j >= least
    lp.set(above, least + 1 + j, 1);
    lp.set(above, least, -1);
  }
  return solve_lp(lp).objective > kNoWeight;
}

int add_balance_rows(LinearProgram* lp, const Eigen::VectorXd& value) {
  const auto first = static_cast<int>(lp->num_rows());
  for (Eigen::Index i = 0; i < value.size(); ++i) lp->add_row(value[i], value[i]);
  return first;
}

}  // namespace

/// Linear program of Problem (6), with forces in units of `force` and z in units of `z_unit`.
struct Reference::Program {
  LinearProgram lp;
  double force = 1, z_unit = 1;  // [N]
  int z = 0;
  std::vector<int> f_com;  // variable of each finger; -1: position control
};

Reference::Reference(const ContactSet& set)
    : set_(set), environments_{wrenches_of_environment(set)}, fingers_(wrenches_of_fingers(set)) {}

Reference::Reference(const std::vector<const EnvironmentWrenches*>& environments,
                     const std::vector<const FingerWrenches*>& fingers) {
  for (const EnvironmentWrenches* environment : environments) environments_.push_back(*environment);
  for (const FingerWrenches* finger : fingers) fingers_.push_back(*finger);
}

/// Returns the balance of each environment; nothing if one of them and the fingers do not span the
/// space.
std::vector<Reference::Balance> Reference::balances() const {
  std::vector<Balance> all;
  for (const EnvironmentWrenches& environment : environments_) {
    std::vector<const Matrix6Xd*> parts = {&environment.generators};
    for (const FingerWrenches& finger : fingers_) parts.push_back(&finger.generators);
    const EvenRows even(side_by_side(parts));
    if (even.rank < 6) return {};
    const bool exact = set_ && !even.is_identity;
    Balance balance;
    balance.rows = even.matrix;
    balance.environment = exact ? exact_environment(even.matrix, *set_)
                                : exact_product(even.matrix, environment.generators);
    balance.known = exact ? exact_known(even.matrix, *set_)
                          : Eigen::VectorXd(exact_product(even.matrix, environment.known));
    for (std::size_t i = 0; i < fingers_.size(); ++i) {
      balance.fingers.push_back(exact ? exact_finger(even.matrix, *set_, static_cast<int>(i))
                                      : exact_product(even.matrix, fingers_[i].generators));
    }
    all.push_back(balance);
  }
  return all;
}

/// Largest force involved [N]: the known wrench, or all limits together.
double Reference::force_scale() const {
  double limits = 0, known = 0;
  for (const FingerWrenches& finger : fingers_) limits += finger.max_normal_force;
  for (const EnvironmentWrenches& e : environments_) known = std::max(known, e.known.norm());
  return std::max(limits, known) > 0 ? std::max(limits, known) : 1;
}

Reference::Program Reference::program(const std::vector<Balance>& balances, ForceMask force,
                                      const Matrix6Xd& directions) const {
  Program p;
  std::vector<Eigen::MatrixXd> evened;
  double largest = 0;
  for (const Balance& balance : balances) {
    evened.push_back(exact_product(balance.rows, directions));
    largest = std::max(largest, evened.back().cwiseAbs().maxCoeff());
  }
  p.force = force_scale();
  p.z_unit = p.force / largest;
  p.z = p.lp.add_variable(0, kInfinity, 1);  // maximise z  (6)
  p.f_com.assign(fingers_.size(), -1);
  for (std::size_t i = 0; i < fingers_.size(); ++i) {
    const double limit = fingers_[i].max_normal_force / p.force;
    if (is_forced(force, i)) p.f_com[i] = p.lp.add_variable(0, limit);
  }
  for (std::size_t e = 0; e < balances.size(); ++e) {
    const Balance& balance = balances[e];
    for (Eigen::Index d = 0; d < directions.cols(); ++d) {
      // z l_i = R^1/2 (Q_known + W_env C_env k_env i + W_rob C_rob k_rob i)
      const int row = add_balance_rows(&p.lp, -balance.known / p.force);
      p.lp.set_block(row, p.z, -evened[e].col(d) / largest);
      p.lp.set_block(row, add_coefficients(&p.lp, balance.environment, kInfinity, 0),
                     balance.environment);
      for (std::size_t i = 0; i < fingers_.size(); ++i) {
        const FingerWrenches& finger = fingers_[i];
        const int k_rob = add_coefficients(&p.lp, balance.fingers[i], kInfinity, 0);
        p.lp.set_block(row, k_rob, balance.fingers[i]);
        // N_rob' C_rob k_rob i <= f_max; N_rob' A_force C_rob k_rob i = f_com, where f_com <= f_max
        // already ensures the limit.
        const int normal = is_forced(force, i)
                               ? p.lp.add_row(0, 0)
                               : p.lp.add_row(-kInfinity, finger.max_normal_force / p.force);
        p.lp.set_block(normal, k_rob, finger.normal.transpose());
        if (is_forced(force, i)) p.lp.set(normal, p.f_com[i], -1);
      }
    }
  }
  return p;
}

/// Directions that cannot be withstood beyond z with these commanded forces.
std::vector<int> Reference::binding(const std::vector<Balance>& balances, ForceMask force,
                                    const Matrix6Xd& directions, const Stability& stability) const {
  const double beyond = stability.z + kBinding * std::max(1.0, stability.z);
  std::vector<int> found;
  for (Eigen::Index d = 0; d < directions.cols(); ++d) {
    Program p = program(balances, force, directions.col(d));
    p.lp.upper[p.z] = 2 * beyond / p.z_unit;
    for (std::size_t i = 0; i < fingers_.size(); ++i) {
      if (p.f_com[i] < 0) continue;
      const auto k = static_cast<std::size_t>(p.f_com[i]);
      p.lp.lower[k] = p.lp.upper[k] = stability.commanded_forces[i] / p.force;
    }
    if (solve_lp(p.lp).objective * p.z_unit < beyond) found.push_back(static_cast<int>(d));
  }
  return found;
}

Stability Reference::evaluate(const std::vector<Balance>& balances, ForceMask force,
                              const Matrix6Xd& directions) const {
  Stability stability;
  stability.commanded_forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(fingers_.size()));
  if (balances.empty()) return stability;
  std::vector<Balance> limiting;
  for (const Balance& balance : balances) {
    if (!balances_anything(balance.environment)) limiting.push_back(balance);
  }
  if (limiting.empty()) {
    stability.z = kInfinity;
    return stability;
  }
  const Program p = program(limiting, force, directions);
  const LpSolution solution = solve_lp(p.lp);
  stability.z = std::max(0.0, solution.objective * p.z_unit);
  if (solution.status != LpStatus::optimal) return stability;
  for (std::size_t i = 0; i < fingers_.size(); ++i) {
    if (p.f_com[i] < 0) continue;
    stability.commanded_forces[i] =
        std::clamp(solution.x[p.f_com[i]] * p.force, 0.0, fingers_[i].max_normal_force);
  }
  return stability;
}

Stability Reference::evaluate(ForceMask force, const Matrix6Xd& directions) const {
  return evaluate(balances(), force, directions);
}

Stability Reference::max_stability(ForceMask force, const Matrix6Xd& directions) const {
  const std::vector<Balance> even = balances();
  Stability stability = evaluate(even, force, directions);
  if (stability.z > 0 && std::isfinite(stability.z)) {
    stability.binding_directions = binding(even, force, directions, stability);
  }
  return stability;
}

bool Reference::internal_force_is_bounded(ForceMask force) const {
  const auto of = [](const auto& part) -> const Matrix6Xd& {
    return part.jam_generators.cols() > 0 ? part.jam_generators : part.generators;
  };
  // maximise b_env' k_env + b_rob' k_rob subject to W_env C_env k_env + W_rob A_pos C_rob k_rob =
  // 0, k_env >= 0, k_rob >= 0  (5) A feasible k may be scaled. So with k <= 1 an unbounded
  // objective becomes 1 or more, and a bounded one 0: an optimum either way, whose residuals can be
  // checked.
  for (const EnvironmentWrenches& environment : environments_) {
    std::vector<const Matrix6Xd*> parts = {&of(environment)};
    for (std::size_t i = 0; i < fingers_.size(); ++i) {
      if (!is_forced(force, i)) parts.push_back(&of(fingers_[i]));
    }
    const Matrix6Xd generators = side_by_side(parts);
    const EvenRows even(generators);
    Eigen::MatrixXd evened = exact_product(even.matrix, generators);
    if (set_ && !even.is_identity) {
      Eigen::Index next = environment.generators.cols();
      evened.leftCols(next) = exact_environment(even.matrix, *set_);
      for (std::size_t i = 0; i < fingers_.size(); ++i) {
        if (is_forced(force, i)) continue;
        const Eigen::MatrixXd finger = exact_finger(even.matrix, *set_, static_cast<int>(i));
        evened.middleCols(next, finger.cols()) = finger;
        next += finger.cols();
      }
    }
    LinearProgram lp;
    const double rounding = evened.size() == 0 ? 0 : kUnbalanced * evened.cwiseAbs().maxCoeff();
    const auto balance = static_cast<int>(lp.num_rows());
    for (Eigen::Index i = 0; i < evened.rows(); ++i) lp.add_row(-rounding, rounding);
    lp.set_block(balance, add_coefficients(&lp, evened, 1, 1), evened);
    if (solve_lp(lp).objective >= 0.5) return false;
  }
  return true;
}

}  // namespace graspless::mechanics
