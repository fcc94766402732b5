// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/load_step.hpp"

#include <algorithm>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "mechanics/lp/program.hpp"

namespace graspless::clasp {
namespace {

using Eigen::VectorXd;
using mechanics::kInfinity;
using mechanics::Vector6d;

/// The primal program with all contacts: the move, then the yields.
mechanics::LpSolution oracle(const Vector6d& load, const std::vector<LoadContact>& contacts,
                             const VectorXd& limits) {
  mechanics::LinearProgram lp;
  for (int k = 0; k < 6; ++k) lp.add_variable(-kMove, kMove, load[k]);
  const int give = lp.add_row(-kInfinity, kGive);
  for (const double limit : limits) lp.set(give, lp.add_variable(0, kInfinity), limit);
  for (const LoadContact& contact : contacts) {
    const int row = lp.add_row(-kInfinity, contact.gap);
    lp.set_block(row, 0, contact.row.transpose());
    lp.set_block(row, 6, -contact.opens.transpose());
  }
  return mechanics::solve_lp(lp);
}

/// Contacts that are all known.
struct Listed : LoadContacts {
  explicit Listed(const std::vector<LoadContact>& contacts) {
    for (const LoadContact& contact : contacts) of_point[contact.point] = &contact;
  }
  const LoadContact* at(Eigen::Index point) override { return of_point.at(point); }
  std::vector<const LoadContact*> near(const Vector6d& /*move*/,
                                       const VectorXd& /*yield*/) override {
    std::vector<const LoadContact*> all;
    for (const auto& [point, contact] : of_point) all.push_back(contact);
    return all;
  }

  std::map<Eigen::Index, const LoadContact*> of_point;
};

std::vector<LoadContact> random_contacts(Eigen::Index count, int joints, std::mt19937_64& rng) {
  std::uniform_real_distribution<double> side(-1, 1);
  std::vector<LoadContact> contacts;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector6d row = Vector6d::NullaryExpr([&] { return side(rng); });
    const VectorXd opens = VectorXd::NullaryExpr(joints, [&] { return side(rng) + 0.6; });
    contacts.push_back({i, row.normalized(), opens, std::max(0.0, side(rng))});
  }
  return contacts;
}

TEST(LoadStepper, FindsTheStepForAllContacts) {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> side(-1, 1);
  int stopped = 0;
  for (int sample = 0; sample < 200; ++sample) {
    const int joints = 1 + sample % 3;
    const VectorXd limits = VectorXd::Constant(joints, 0.5 + sample % 7);
    LoadStepper stepper(limits);
    auto contacts = random_contacts(sample, joints, rng);
    const Vector6d load = Vector6d::NullaryExpr([&] { return 5 * side(rng); });
    for (int step = 0; step < 3; ++step) {
      Listed listed(contacts);
      const LoadStep found = stepper.step(load, listed);
      const mechanics::LpSolution expected = oracle(load, contacts, limits);
      ASSERT_EQ(expected.status, mechanics::LpStatus::optimal);
      EXPECT_NEAR(load.dot(found.move), load.dot(expected.x.head<6>()), 1e-5);
      EXPECT_NEAR(found.effort, expected.duals[0], 1e-6);
      EXPECT_LE(found.move.lpNorm<Eigen::Infinity>(), kMove + 1e-9);
      stopped += found.effort > 0;
      std::shuffle(contacts.begin(), contacts.end(), rng);
      for (LoadContact& contact : contacts)
        contact.gap = std::max(0.0, contact.gap - contact.row.dot(found.move) / 2);
    }
  }
  EXPECT_GT(stopped, 50);
}

TEST(LoadStepper, MovesFreelyWithoutContacts) {
  LoadStepper stepper(VectorXd::Ones(1));
  Listed none({});
  const LoadStep step = stepper.step(Vector6d::Unit(2), none);
  EXPECT_DOUBLE_EQ(step.move[2], kMove);
  EXPECT_EQ(step.effort, 0);
}

}  // namespace
}  // namespace graspless::clasp
