// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/equilibrium/inner_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "graspless/mechanics/stability_solver.hpp"

#include "mechanics/contacts/cones.hpp"
#include "mechanics/contacts/wrenches.hpp"
#include "mechanics/equilibrium/least_forces.hpp"
#include "mechanics/lp/conditioning.hpp"
#include "mechanics/lp/program.hpp"

namespace graspless::mechanics {
namespace {

/// Optimum: every force is t apex + edges k', k' >= 0.
struct Solution {
  double t = 0;
  Eigen::VectorXd k;
};

/// Linear program in t and k' >= 0.
class ReserveProgram {
 public:
  ReserveProgram(double t_max, const Matrix6d& even, const Vector6d& known)
      : t_(lp_.add_variable(0, t_max, 1)), even_(even) {
    const Vector6d right = -even * known;
    for (int i = 0; i < 6; ++i) lp_.add_row(right[i], right[i]);
  }
  /// Adds k' for these generators and the wrench per unit of t. Returns the index of the first k'.
  int add(const Matrix6Xd& generators, const Vector6d& apex) {
    const auto first = static_cast<int>(lp_.num_variables());
    for (Eigen::Index j = 0; j < generators.cols(); ++j) lp_.add_variable(0, kInfinity);
    lp_.set_block(0, first, even_ * generators);
    on_t_ += even_ * apex;
    return first - 1;  // the solution's k does not contain t
  }
  /// Adds the normal force of one finger: f_com, or at most f_max less the reserve.
  void add_normal(int first, const FingerWrenches& finger, double on_t, bool force, double f_com) {
    const int row =
        force ? lp_.add_row(f_com, f_com) : lp_.add_row(-kInfinity, finger.max_normal_force);
    lp_.set_block(row, first + 1, finger.normal.transpose());
    lp_.set(row, t_, on_t);
  }
  std::optional<Solution> solve(double kept) {
    lp_.set_block(0, t_, on_t_);
    const LpSolution solution = solve_lp(lp_);
    if (solution.status != LpStatus::optimal) return std::nullopt;
    const double largest = solution.objective, t = kept * largest;
    if (largest > 0) {  // otherwise there is nothing to choose from
      if (const auto least = least_squares(t)) return Solution{t, *least};
    }
    return Solution{largest, solution.x.tail(solution.x.size() - 1)};
  }

 private:
  /// Returns k' >= 0 of least squares for a t below the largest one.
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
  Matrix6d even_;                     // factor on both sides of the balance
  Vector6d on_t_ = Vector6d::Zero();  // coefficients of t in the balance
};

Vector6d scaled_wrench(const ContactSet& set, const Eigen::Vector3d& p_OC,
                       const Eigen::Vector3d& force_O) {
  Vector6d wrench;
  wrench << force_O, (p_OC - set.com_O).cross(force_O);
  return set.wrench_scale * wrench;
}

/// Largest t such that all coefficients of a force within its cone can be at least t.
double least_coefficient(const Eigen::Matrix3Xd& cone, const Eigen::Vector3d& n_O,
                         const Eigen::Vector3d& force_O) {
  if (cone.cols() == 1) return force_O.norm();
  const Eigen::Vector3d sum = cone.rowwise().sum();
  double t = n_O.dot(force_O) / n_O.dot(sum);
  for (Eigen::Index j = 0; j < cone.cols(); ++j) {
    const Eigen::Vector3d inward = cone.col(j).cross(cone.col((j + 1) % cone.cols()));
    if (inward.norm() > 1e-12) t = std::min(t, inward.dot(force_O) / inward.dot(sum));
  }
  return std::max(t, 0.0);
}

double margin_of(const ContactSet& set, const std::vector<FingerMode>& modes,
                 const Equilibrium& forces) {
  double margin = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    const Contact& c = set.contacts[i];
    const Eigen::Vector3d force = forces.contact_forces_O.col(i);
    margin = std::min(margin, least_coefficient(cone_of(c, set.cone_edges), c.n_O, force));
  }
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    const Finger& f = set.fingers[i];
    const Eigen::Vector3d force = forces.finger_forces_O.col(i);
    margin = std::min(margin, least_coefficient(cone_of(f, set.cone_edges), f.n_O, force));
    if (modes[i] == FingerMode::force) continue;
    margin = std::min(margin, f.max_normal_force - f.n_O.dot(force));
  }
  return std::isfinite(margin) ? margin : 0;
}

}  // namespace

double largest_force(const ContactSet& set) {
  double sum = set.known_wrench_O.head<3>().norm();
  for (const Finger& finger : set.fingers) sum += finger.max_normal_force;
  return sum;
}

std::optional<Equilibrium> inner_forces(const ContactSet& set, const std::vector<FingerMode>& modes,
                                        const Eigen::VectorXd& commanded_forces,
                                        const std::vector<Reserve>& reserves, double t_max,
                                        double kept) {
  const EnvironmentWrenches environment = wrenches_of_environment(set);
  const std::vector<FingerWrenches> fingers = wrenches_of_fingers(set);
  ReserveProgram program(t_max, balance_conditioning(environment, fingers), environment.known);
  Vector6d apices = Vector6d::Zero();
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    apices += scaled_wrench(set, set.contacts[i].p_OC, reserves[i].apex_O);
  }
  int next = program.add(environment.generators, apices);
  std::vector<int> first_finger;
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    const Reserve& reserve = reserves[set.contacts.size() + i];
    const Finger& f = set.fingers[i];
    first_finger.push_back(
        program.add(fingers[i].generators, scaled_wrench(set, f.p_OC, reserve.apex_O)));
    const bool force = modes[i] == FingerMode::force;
    program.add_normal(first_finger[i], fingers[i],
                       f.n_O.dot(reserve.apex_O) + (force ? 0 : reserve.normal), force,
                       commanded_forces[i]);
  }
  const auto solution = program.solve(kept);
  if (!solution) return std::nullopt;
  Equilibrium forces;
  forces.contact_forces_O.resize(3, static_cast<Eigen::Index>(set.contacts.size()));
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    const Eigen::Matrix3Xd cone = cone_of(set.contacts[i], set.cone_edges);
    const auto edges = static_cast<int>(cone.cols());
    forces.contact_forces_O.col(i) =
        solution->t * reserves[i].apex_O + cone * solution->k.segment(next, edges);
    next += edges;
  }
  forces.finger_forces_O.resize(3, static_cast<Eigen::Index>(fingers.size()));
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    const Eigen::Matrix3Xd cone = cone_of(set.fingers[i], set.cone_edges);
    forces.finger_forces_O.col(i) = solution->t * reserves[set.contacts.size() + i].apex_O +
                                    cone * solution->k.segment(first_finger[i], cone.cols());
  }
  forces.margin = margin_of(set, modes, forces);
  return forces;
}

}  // namespace graspless::mechanics
