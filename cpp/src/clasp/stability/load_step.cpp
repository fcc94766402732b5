// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Primal: maximise load . move over the move and the yield of the joints y >= 0, such that
// |move_k| <= kMove, row_i . move <= gap_i + opens_i . y for each contact, and limits . y <= give.
// The dual is solved: contact forces f_i >= 0 balance the load, and no joint needs more than the
// effort e >= 0: sum_i opens_i f_i <= e limits. A contact that the primal solution does not pass
// has no force in the dual, so contacts are added until none is passed.
#include "clasp/stability/load_step.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "mechanics/lp/program.hpp"

namespace graspless::clasp {
namespace {

using Eigen::VectorXd;
using mechanics::kInfinity;
using mechanics::Vector6d;

constexpr double kPassed = 1e-6;       // a contact passed by less is kept [mm]
constexpr std::ptrdiff_t kAdded = 12;  // contacts that are added at once

using Contacts = std::vector<const LoadContact*>;

/// Dual program: effort, forces of the bounds on the move, and contact forces.
mechanics::LinearProgram program(const Vector6d& load, const Contacts& contacts,
                                 const VectorXd& limits, double give) {
  mechanics::LinearProgram lp;
  for (int k = 0; k < 6; ++k) lp.add_row(load[k], load[k]);
  for (Eigen::Index j = 0; j < limits.size(); ++j) lp.add_row(-kInfinity, 0);
  const int effort = lp.add_variable(0, kInfinity, -give);
  for (int j = 0; j < limits.size(); ++j) lp.set(6 + j, effort, -limits[j]);
  for (int k = 0; k < 6; ++k) {
    for (const double sign : {1.0, -1.0}) lp.set(k, lp.add_variable(0, kInfinity, -kMove), sign);
  }
  for (const LoadContact* contact : contacts) {
    const int column = lp.add_variable(0, kInfinity, -contact->gap);
    lp.set_block(0, column, contact->row);
    lp.set_block(6, column, contact->opens);
  }
  return lp;
}

/// The contacts not in `known` that a move passes most, at most kAdded of them.
Contacts passed(LoadContacts& contacts, const Vector6d& move, const VectorXd& yield,
                const std::set<Eigen::Index>& known) {
  std::vector<std::tuple<double, Eigen::Index, const LoadContact*>> found;
  for (const LoadContact* contact : contacts.near(move, yield)) {
    const double beyond = contact->row.dot(move) - contact->gap - contact->opens.dot(yield);
    if (beyond > kPassed && known.count(contact->point) == 0)
      found.emplace_back(-beyond, contact->point, contact);
  }
  const auto count = std::min(kAdded, static_cast<std::ptrdiff_t>(found.size()));
  std::partial_sort(found.begin(), found.begin() + count, found.end());
  Contacts most;
  for (auto it = found.begin(); it != found.begin() + count; ++it)
    most.push_back(std::get<const LoadContact*>(*it));
  return most;
}

/// The joint whose motor does the most work against the load.
Eigen::Index most_yielding(const VectorXd& yield, const VectorXd& limits) {
  Eigen::Index joint = -1;
  if (yield.size() == 0 || !(yield.cwiseProduct(limits).maxCoeff(&joint) > 0)) return -1;
  return joint;
}

}  // namespace

LoadStep LoadStepper::step(const Vector6d& load, LoadContacts& contacts) {
  Contacts used;
  for (const Eigen::Index point : points_) {
    if (const LoadContact* contact = contacts.at(point)) used.push_back(contact);
  }
  while (true) {
    const mechanics::LpSolution found = mechanics::solve_lp(program(load, used, limits_, give_));
    if (found.status != mechanics::LpStatus::optimal) return {Vector6d::Zero(), kInfinity, -1};
    const VectorXd yield = found.duals.tail(limits_.size());
    const bool is_free = (found.x.tail(used.size()).array() == 0).all();
    const LoadStep step{-found.duals.head<6>(), found.x[0], most_yielding(yield, limits_), is_free};
    const Contacts added = passed(contacts, step.move, yield, points_);
    if (added.empty()) return step;
    for (const LoadContact* contact : added) {
      used.push_back(contact);
      points_.insert(contact->point);
    }
  }
}

}  // namespace graspless::clasp
