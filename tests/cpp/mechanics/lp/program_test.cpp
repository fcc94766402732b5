// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/lp/program.hpp"

#include <limits>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "complaint.hpp"

namespace graspless::mechanics {
namespace {

/// maximise x + 2 y subject to x + y <= 4, x - y >= -2, 0 <= x <= 3.
LinearProgram small() {
  LinearProgram lp;
  const int x = lp.add_variable(0, 3, 1), y = lp.add_variable(-kInfinity, kInfinity, 2);
  const int sum = lp.add_row(-kInfinity, 4), difference = lp.add_row(-2, kInfinity);
  lp.set(sum, x, 1);
  lp.set(sum, y, 1);
  lp.set(difference, x, 1);
  lp.set(difference, y, -1);
  return lp;
}

TEST(Lp, Optimal) {
  const LpSolution solution = solve_lp(small());
  ASSERT_EQ(solution.status, LpStatus::optimal);
  EXPECT_DOUBLE_EQ(solution.objective, 7);
  EXPECT_TRUE(solution.x.isApprox(Eigen::Vector2d(1, 3), 1e-15));
  EXPECT_TRUE(solution.duals.isApprox(Eigen::Vector2d(1.5, -0.5), 1e-15));
}

TEST(Lp, InfeasibleAndUnbounded) {
  LinearProgram lp = small();
  lp.row_lower[0] = 10;
  lp.row_upper[0] = kInfinity;
  EXPECT_EQ(solve_lp(lp).status, LpStatus::infeasible);
  lp = small();
  lp.row_upper[0] = kInfinity;
  lp.row_lower[1] = -kInfinity;
  EXPECT_EQ(solve_lp(lp).status, LpStatus::unbounded);
  EXPECT_EQ(solve_lp(lp).objective, kInfinity);
}

TEST(Lp, WithoutRowsOrVariables) {
  LinearProgram lp;
  EXPECT_EQ(solve_lp(lp).status, LpStatus::optimal);
  lp.add_variable(-1, 5, 2);
  EXPECT_EQ(solve_lp(lp).objective, 10);
  LinearProgram rows;
  rows.add_row(-1, 1);
  EXPECT_EQ(solve_lp(rows).status, LpStatus::optimal);
  rows.add_row(1, 2);
  EXPECT_EQ(solve_lp(rows).status, LpStatus::infeasible);
}

/// Primal and dual answers bound each other: equal values prove both.
TEST(Lp, StrongDualityOnRandomProgrammes) {
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int trial = 0; trial < 60; ++trial) {
    const int m = 3 + trial, n = 2 * m;  // up to sizes of the sparse factorisation
    LinearProgram lp;
    for (int j = 0; j < n; ++j) lp.add_variable(0, 5, u(rng));
    for (int i = 0; i < m; ++i) lp.add_row(-kInfinity, 1 + u(rng));
    Eigen::MatrixXd A(m, n);
    for (int i = 0; i < m; ++i) {
      for (int j = 0; j < n; ++j) A(i, j) = u(rng) > 0.4 ? u(rng) : 0;
    }
    lp.set_block(0, 0, A);
    const LpSolution solution = solve_lp(lp);
    ASSERT_EQ(solution.status, LpStatus::optimal);
    EXPECT_LT(solution.primal_error, 1e-12);
    EXPECT_LT(solution.dual_error, 1e-12);
    const Eigen::Map<const Eigen::VectorXd> c(lp.objective.data(), n), b(lp.row_upper.data(), m);
    const Eigen::VectorXd reduced = c - A.transpose() * solution.duals;
    EXPECT_GE(solution.duals.minCoeff(), 0);
    EXPECT_NEAR(solution.objective, b.dot(solution.duals) + 5 * reduced.cwiseMax(0).sum(), 1e-11);
  }
}

TEST(Lp, BadInputNeverReachesGlpk) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const std::string& words, auto change) {
    LinearProgram lp = small();
    change(&lp);
    expect_refused([&] { solve_lp(lp); }, words);
  };
  refused("objective of variable 1", [&](LinearProgram* lp) { lp->objective[1] = nan; });
  refused("bounds of variable 0", [&](LinearProgram* lp) { lp->upper[0] = nan; });
  refused("bounds of variable 0", [&](LinearProgram* lp) { lp->upper[0] = -1; });
  refused("bounds of variable 1", [&](LinearProgram* lp) { lp->lower[1] = kInfinity; });
  refused("bounds of row 0", [&](LinearProgram* lp) { lp->row_upper[0] = -kInfinity; });
  refused("entry (0, 1) must be finite", [&](LinearProgram* lp) {
    lp->entries[1] = {0, 1, kInfinity};
  });
  refused("entry (0, 1) must be given once", [&](LinearProgram* lp) { lp->set(0, 1, 3); });
  refused("entry (2, 0) must lie in the matrix", [&](LinearProgram* lp) { lp->set(2, 0, 3); });
  refused("entry (0, -1) must lie in the matrix", [&](LinearProgram* lp) { lp->set(0, -1, 3); });
}

TEST(Lp, ThreadsHaveTheirOwnGlpk) {
  std::vector<std::thread> threads;
  std::vector<double> sums(4, 0);
  for (std::size_t t = 0; t < 4; ++t) {
    threads.emplace_back([&sums, t] {
      for (int i = 0; i < 50; ++i) sums[t] += solve_lp(small()).objective;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const double sum : sums) EXPECT_DOUBLE_EQ(sum, 350);
}

}  // namespace
}  // namespace graspless::mechanics
