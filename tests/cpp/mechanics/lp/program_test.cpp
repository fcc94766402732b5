// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/lp/program.hpp"

#include <limits>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "mechanics/lp/basis.hpp"

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

/// Programs that change step by step have the same answers from the basis of the last one, from
/// that of another one, and from none.
TEST(Lp, AnyBasisMayBeTheFirst) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> side(-1, 1);
  LpBasis last, other;
  solve_lp(small(), other);
  int optimal = 0;
  Eigen::MatrixXd A(5, 12);
  for (int step = 0; step < 200; ++step) {
    if (step % 20 == 0) A = Eigen::MatrixXd::NullaryExpr(5, 12, [&] { return side(rng); });
    A += 0.02 * Eigen::MatrixXd::NullaryExpr(5, 12, [&] { return side(rng); });
    LinearProgram lp;
    for (int j = 0; j < A.cols(); ++j) lp.add_variable(0, 1 + side(rng), side(rng));
    for (int i = 0; i < A.rows(); ++i) lp.add_row(i < 2 ? 0.3 * side(rng) : -kInfinity, 0.4);
    lp.set_block(0, 0, A);
    const LpSolution expected = solve_lp(lp);
    for (LpBasis* basis : {&last, &other}) {
      const LpSolution found = solve_lp(lp, *basis);
      ASSERT_EQ(found.status, expected.status);
      if (found.status != LpStatus::optimal) continue;
      EXPECT_NEAR(found.objective, expected.objective, 1e-12);
      EXPECT_EQ(basis->variables.size(), 12U);
      ++optimal;
    }
    solve_lp(small(), other);
  }
  EXPECT_GT(optimal, 100);
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

/// Wrenches of five contacts, of which two at one place oppose each other, so that forces of any
/// size cancel. GLPK's dual method calls the program infeasible, its primal one gives up, and 0
/// fulfils all rows.
TEST(Lp, NarrowRowsAreNotInfeasible) {
  Eigen::Matrix<double, 9, 6> different;  // one wrench a row
  different << 0.24806759339941245, 0.60334202086934019, -0.75791878060251256, -0.96458973094956146,
      -0.12746279630077503, -0.41717809771544689,  //
      0.98453366686474508, -0.012661611088327335, 0.17473735265966309, -0.093699481873995211,
      -0.40489815710254101, 0.49859763897653619,  //
      0.29746685629899966, 0.91254024447427851, 0.28068446985612594, 0.31592788730907628,
      -0.0083911932214368601, -0.3075366940876394,  //
      0.16044679664552267, 0.0061231641128045499, 0.98702549729347833, -0.49045116659033688,
      0.41328935032397784, 0.077161816266359054,  //
      0.21905145300550879, 0.95080645868249702, 0.21905145300550879, -0.72459331422895024,
      6.6849198304963497e-06, 0.72456429791856569,  //
      0.21905145300550874, 0.21905145300550888, 0.95080645868249702, 0.72455761299873511,
      -0.72455761299873522, 0,  //
      0.95080645868249702, 0.21905145300550852, 0.21905145300550902, -6.6849198299967494e-06,
      0.72459331422895001, -0.72456429791856602,  //
      -0.57735026918962584, -0.57735026918962584, -0.57735026918962584, -1.032915715972065,
      1.0369505429875809, -0.0040348270155159405,  //
      -0.57735026918962584, -0.57735026918962584, -0.57735026918962584, 0, 0, 0;
  LinearProgram lp;
  for (int row = 0; row < 6; ++row) lp.add_row(-1.03695e-12, 1.03695e-12);
  for (const int wrench : {0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 7, 7, 8, 8, 8}) {
    lp.set_block(0, lp.add_variable(0, 1, 1), different.row(wrench).transpose());
  }
  const LpSolution solution = solve_lp(lp);
  ASSERT_EQ(solution.status, LpStatus::optimal);
  EXPECT_GE(solution.objective, 1);
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
