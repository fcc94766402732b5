// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/equilibrium/least_forces.hpp"

#include <random>

#include <gtest/gtest.h>

namespace graspless::mechanics {
namespace {

/// A problem with some x > 0 that keeps it, at random.
LeastForces random_problem(std::mt19937_64& rng, int equal, int bounded, int columns) {
  std::normal_distribution<double> normal;
  LeastForces problem;
  problem.A.resize(equal + bounded, columns);
  for (double& value : problem.A.reshaped()) value = normal(rng);
  Eigen::VectorXd inside(columns);
  for (double& value : inside) value = 0.1 + std::abs(normal(rng));
  problem.upper = problem.A * inside;
  for (int i = 0; i < equal + bounded; ++i) {
    problem.is_equal.push_back(i < equal);
    if (i >= equal) problem.upper[i] += 0.1;
  }
  return problem;
}

double excess(const LeastForces& problem, const Eigen::VectorXd& x) {
  double worst = -x.minCoeff();
  const Eigen::VectorXd over = problem.A * x - problem.upper;
  for (Eigen::Index i = 0; i < over.size(); ++i) {
    const bool is_equal = problem.is_equal[i];
    worst = std::max(worst, is_equal ? std::abs(over[i]) : over[i]);
  }
  return worst;
}

TEST(LeastForces, KeepsTheRowsAndNoStepInsideThemIsShorter) {
  std::mt19937_64 rng(1);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 200; ++run) {
    const LeastForces problem = random_problem(rng, 6, run % 3, 12 + run % 30);
    const auto x = least_forces(problem);
    ASSERT_TRUE(x) << run;
    EXPECT_LT(excess(problem, *x), 1e-9);
    const LeastForces other = problem;
    for (int trial = 0; trial < 20; ++trial) {  // towards feasible points, |x| only grows
      Eigen::VectorXd target(x->size());
      for (double& value : target) value = std::abs(normal(rng));
      LeastForces shifted = other;
      shifted.upper -= other.A * target;  // min |y| with A (target + y) within the rows
      const auto y = least_forces(shifted);
      if (!y) continue;
      const Eigen::VectorXd feasible = target + *y;
      if (excess(problem, feasible) > 1e-9) continue;
      EXPECT_GE(x->dot(feasible - *x), -1e-8);
    }
  }
}

TEST(LeastForces, AColumnTwiceSharesEvenly) {
  LeastForces problem;
  problem.A = Eigen::MatrixXd::Ones(1, 4);
  problem.upper = Eigen::VectorXd::Constant(1, 8);
  problem.is_equal = {true};
  const auto x = least_forces(problem);
  ASSERT_TRUE(x);
  EXPECT_TRUE(x->isApprox(Eigen::Vector4d::Constant(2), 1e-10));
}

TEST(LeastForces, ABoundThatDoesNotPushIsAsIfItWereNotThere) {
  LeastForces problem;
  problem.A = Eigen::MatrixXd::Identity(2, 2);
  problem.A(0, 1) = 1;
  problem.upper = Eigen::Vector2d(2, 5);
  problem.is_equal = {true, false};
  EXPECT_TRUE(least_forces(problem)->isApprox(Eigen::Vector2d(1, 1), 1e-10));
  problem.upper[1] = 0.5;
  EXPECT_TRUE(least_forces(problem)->isApprox(Eigen::Vector2d(1.5, 0.5), 1e-10));
}

TEST(LeastForces, NothingWhereNothingKeepsTheRows) {
  LeastForces problem;
  problem.A = Eigen::MatrixXd::Ones(1, 3);
  problem.upper = Eigen::VectorXd::Constant(1, -1);
  problem.is_equal = {true};
  EXPECT_FALSE(least_forces(problem));
}

}  // namespace
}  // namespace graspless::mechanics
