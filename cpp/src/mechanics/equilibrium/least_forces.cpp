// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Solves a least-squares problem over x >= 0 by its dual: x = max(0, A^T lambda), where the
// multipliers lambda of the rows that hold with equality follow from Newton's method on
// A max(0, A^T lambda) = upper.
#include "mechanics/equilibrium/least_forces.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace graspless::mechanics {
namespace {

constexpr int kMaxSteps = 100;
constexpr double kTolerance = 1e-12;  // of the rows, relative
constexpr double kDamping = 1e-13;    // of the Hessian, relative

using Matrix = LeastForces::Matrix;
using Rows = LeastForces::Rows;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                             LeastForces::kMaxRows, LeastForces::kMaxRows>;

/// Multipliers, the x that follows from them, and the value and gradient of the dual, which is
/// convex.
struct Point {
  Rows lambda;
  Eigen::VectorXd x;
  double value;
  Rows gradient;
  Point(const Matrix& A, const Rows& b, const Rows& at)
      : lambda(at),
        x((A.transpose() * at).cwiseMax(0)),
        value(0.5 * x.squaredNorm() - b.dot(at)),
        gradient(A * x - b) {}
};

/// Lower half of the sum of a a^T over the columns a of A at which x is positive; over all columns
/// without x.
Square squares(const Matrix& A, const Eigen::VectorXd* x) {
  Square sum = Square::Zero(A.rows(), A.rows());
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    if (x != nullptr && (*x)[j] <= 0) continue;
    for (Eigen::Index k = 0; k < A.rows(); ++k) {
      for (Eigen::Index i = k; i < A.rows(); ++i) sum(i, k) += A(i, j) * A(k, j);
    }
  }
  return sum;
}

/// Returns lambda for A x = b.
std::optional<Rows> multipliers(const Matrix& A, const Rows& b) {
  const double enough = kTolerance * (1 + b.norm()), damping = kDamping * (1 + A.squaredNorm());
  Point now(A, b, Rows::Zero(A.rows()));
  for (int step = 0; step < kMaxSteps; ++step) {
    if (now.gradient.norm() <= enough) return now.lambda;
    Square hessian = squares(A, step > 0 ? &now.x : nullptr);
    hessian.diagonal().array() += damping;
    const Rows direction = -hessian.ldlt().solve(now.gradient);
    const double slope = now.gradient.dot(direction);
    const auto is_better = [&](const Point& next, double length) {
      // Near the solution, values differ by less than rounding errors; the gradient still
      // decreases.
      return next.value <= now.value + 1e-4 * length * slope ||
             next.gradient.norm() <= 0.5 * now.gradient.norm();
    };
    double length = 1;
    Point next(A, b, now.lambda + direction);
    while (length > 1e-10 && !is_better(next, length)) {
      length /= 2;
      next = Point(A, b, now.lambda + length * direction);
    }
    now = std::move(next);
  }
  return std::nullopt;
}

/// Rows that hold with equality, as A x = b.
struct Held {
  std::vector<Eigen::Index> rows;
  Matrix A;
  Rows b;
  Held(const LeastForces& problem, const std::vector<bool>& is_held) {
    for (std::size_t i = 0; i < is_held.size(); ++i) {
      if (is_held[i]) rows.push_back(static_cast<Eigen::Index>(i));
    }
    const auto count = static_cast<Eigen::Index>(rows.size());
    A.resize(count, problem.A.cols());
    b.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      A.row(i) = problem.A.row(rows[i]);
      b[i] = problem.upper[rows[i]];
    }
  }
};

}  // namespace

std::optional<Eigen::VectorXd> least_forces(const LeastForces& problem) {
  std::vector<bool> is_held = problem.is_equal;
  for (std::size_t round = 0; round <= 2 * is_held.size(); ++round) {
    const Held held(problem, is_held);
    const auto lambda = multipliers(held.A, held.b);
    if (!lambda) return std::nullopt;
    const Eigen::VectorXd x = (held.A.transpose() * *lambda).cwiseMax(0);
    const Rows excess = problem.A * x - problem.upper;
    bool changed = false;
    for (std::size_t k = 0; k < held.rows.size(); ++k) {  // releases upper bounds that push
      const auto i = static_cast<std::size_t>(held.rows[k]);
      if (problem.is_equal[i] || (*lambda)[k] <= 0) continue;
      is_held[i] = false;
      changed = true;
    }
    for (std::size_t i = 0; i < is_held.size(); ++i) {
      const double room = kTolerance * (1 + std::abs(problem.upper[i]));
      if (is_held[i] || problem.is_equal[i] || excess[i] <= 10 * room) {
        continue;
      }
      is_held[i] = changed = true;
    }
    if (!changed) return x;
  }
  return std::nullopt;
}

}  // namespace graspless::mechanics
