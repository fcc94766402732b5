// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Computes the vertex of a basis. A simplex method updates its factors hundreds of times and
// accepts bounds to a tolerance; one new factorisation with refinement restores full accuracy.
#include "mechanics/lp/basis.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <Eigen/SparseLU>

namespace graspless::mechanics {
namespace {

constexpr Eigen::Index kDense = 48;  // up to this size a dense factorisation is faster
constexpr int kRefinements = 3;

using Sparse = Eigen::SparseMatrix<double>;
using LongVector = LpVertex::Vector;

/// Square system of the rows at a bound and the basic variables. Basic rows are not part of it:
/// they follow from x, and their dual is 0.
struct ActiveSystem {
  std::vector<int> row_of, column_of;  // position in the system, or -1
  Eigen::Index size = 0;
  Sparse A;
};

ActiveSystem active_system(const LinearProgram& lp, const LpBasis& basis) {
  ActiveSystem system;
  int rows = 0, columns = 0;
  for (const auto status : basis.rows) {
    system.row_of.push_back(status == BasisStatus::basic ? -1 : rows++);
  }
  for (const auto status : basis.variables) {
    system.column_of.push_back(status == BasisStatus::basic ? columns++ : -1);
  }
  system.size = rows == columns ? rows : -1;
  if (rows != columns) return system;
  std::vector<Eigen::Triplet<double>> inside;
  for (const auto& entry : lp.entries) {
    const int row = system.row_of[entry.row()];
    const int column = system.column_of[entry.col()];
    if (row >= 0 && column >= 0) inside.emplace_back(row, column, entry.value());
  }
  system.A.resize(rows, columns);
  system.A.setFromTriplets(inside.begin(), inside.end());
  return system;
}

LongVector product(const Sparse& A, const LongVector& x, bool transposed) {
  LongVector result = LongVector::Zero(A.rows());  // A is square
  for (Eigen::Index j = 0; j < A.outerSize(); ++j) {
    for (Sparse::InnerIterator it(A, j); it; ++it) {
      const auto value = static_cast<long double>(it.value());
      if (transposed) {
        result[it.col()] += value * x[it.row()];
      } else {
        result[it.row()] += value * x[it.col()];
      }
    }
  }
  return result;
}

/// Solves A x = b by `solve`, refined with residuals of extended precision.
template <class Solve>
LongVector refined(const Sparse& A, bool transposed, const LongVector& b, const Solve& solve) {
  LongVector x = LongVector::Zero(b.size());
  for (int i = 0; i <= kRefinements; ++i) {
    const LongVector residual = b - product(A, x, transposed);
    x += solve(Eigen::VectorXd(residual.cast<double>())).template cast<long double>();
  }
  return x;
}

/// Solves A x_B = b and A' y = c. Returns false if A is singular.
bool solve_both(const Sparse& A, const LongVector& b, const LongVector& c, LongVector* x,
                LongVector* y) {
  if (A.rows() == 0) {
    *x = *y = LongVector(0);
    return true;
  }
  const auto solve = [&](auto& lu) {
    *x = refined(A, false, b,
                 [&](const Eigen::VectorXd& r) -> Eigen::VectorXd { return lu.solve(r); });
    *y = refined(A, true, c, [&](const Eigen::VectorXd& r) -> Eigen::VectorXd {
      return lu.transpose().solve(r);
    });
  };
  if (A.rows() <= kDense) {
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu{Eigen::MatrixXd(A)};
    solve(lu);
  } else {
    Eigen::SparseLU<Sparse> lu(A);
    if (lu.info() != Eigen::Success) return false;
    solve(lu);
  }
  return x->cast<double>().allFinite() && y->cast<double>().allFinite();
}

double bound(BasisStatus status, double lower, double upper) {
  switch (status) {
    case BasisStatus::at_lower:
    case BasisStatus::fixed:
      return lower;
    case BasisStatus::at_upper:
      return upper;
    default:
      return 0;
  }
}

/// Size of a reduced cost of the wrong sign, for maximisation; otherwise 0.
double sign_error(BasisStatus status, double reduced) {
  switch (status) {
    case BasisStatus::at_lower:
      return std::max(0.0, reduced);
    case BasisStatus::at_upper:
      return std::max(0.0, -reduced);
    case BasisStatus::fixed:
      return 0;
    default:
      return std::abs(reduced);
  }
}

LongVector activities(const LinearProgram& lp, const LongVector& x) {
  LongVector rows = LongVector::Zero(lp.num_rows());
  for (const auto& entry : lp.entries) rows[entry.row()] += x[entry.col()] * entry.value();
  return rows;
}

LongVector reduced_costs(const LinearProgram& lp, const LongVector& y) {
  LongVector reduced = Eigen::Map<const Eigen::VectorXd>(lp.objective.data(), lp.num_variables())
                           .cast<long double>();
  for (const auto& entry : lp.entries) reduced[entry.col()] -= y[entry.row()] * entry.value();
  return reduced;
}

double primal_error(const LinearProgram& lp, const LongVector& x) {
  long double worst = 0;
  const auto check = [&](const LongVector& values, const std::vector<double>& lower,
                         const std::vector<double>& upper) {
    for (std::size_t i = 0; i < lower.size(); ++i) {
      const long double value = values[i];
      worst = std::max({worst, lower[i] - value, value - upper[i]});
    }
  };
  check(activities(lp, x), lp.row_lower, lp.row_upper);
  check(x, lp.lower, lp.upper);
  return static_cast<double>(worst);
}

double dual_error(const LinearProgram& lp, const LpBasis& basis, const LongVector& y) {
  const LongVector reduced = reduced_costs(lp, y);
  double worst = 0;
  for (Eigen::Index j = 0; j < reduced.size(); ++j) {
    const BasisStatus status = basis.variables[j];
    worst = std::max(worst, sign_error(status, static_cast<double>(reduced[j])));
  }
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    // The dual is what the objective would gain if the row left its bound.
    const BasisStatus status = basis.rows[i];
    if (status == BasisStatus::basic) continue;
    worst = std::max(worst, sign_error(status, static_cast<double>(y[i])));
  }
  return worst;
}

LpVertex singular() {
  LpVertex vertex;
  vertex.solution.status = LpStatus::optimal;
  vertex.solution.primal_error = vertex.solution.dual_error = kInfinity;
  return vertex;
}

/// Computes the right-hand sides of A x_B = b and A' y = c, and sets the x that are at a bound.
void right_sides(const LinearProgram& lp, const LpBasis& basis, const ActiveSystem& system,
                 LongVector* x, LongVector* b, LongVector* c) {
  *b = *c = LongVector::Zero(system.size);
  *x = LongVector::Zero(lp.num_variables());
  for (std::size_t j = 0; j < lp.objective.size(); ++j) {
    const int column = system.column_of[j];
    if (column >= 0) {
      (*c)[column] = lp.objective[j];
    } else {
      (*x)[j] = bound(basis.variables[j], lp.lower[j], lp.upper[j]);
    }
  }
  for (std::size_t i = 0; i < lp.row_lower.size(); ++i) {
    const int row = system.row_of[i];
    if (row >= 0) (*b)[row] = bound(basis.rows[i], lp.row_lower[i], lp.row_upper[i]);
  }
  for (const auto& entry : lp.entries) {
    const int row = system.row_of[entry.row()];
    if (row < 0 || system.column_of[entry.col()] >= 0) continue;
    (*b)[row] -= (*x)[entry.col()] * entry.value();
  }
}

/// Factor that magnifies an error to 1, at most 1e12.
long double magnification(double error) { return 1 / std::max(error, 1e-12); }

}  // namespace

LpVertex vertex_of(const LinearProgram& lp, const LpBasis& basis) {
  LpVertex vertex;
  vertex.basis = basis;
  LpSolution& solution = vertex.solution;
  solution.status = basis.status;
  solution.objective = basis.status == LpStatus::unbounded ? kInfinity : 0;
  if (basis.status != LpStatus::optimal) return vertex;
  const ActiveSystem system = active_system(lp, basis);
  if (system.size < 0) return singular();
  LongVector b, c, x, y;
  right_sides(lp, basis, system, &vertex.x, &b, &c);
  if (!solve_both(system.A, b, c, &x, &y)) return singular();
  long double objective = 0;
  for (std::size_t j = 0; j < lp.objective.size(); ++j) {
    const auto k = static_cast<Eigen::Index>(j);
    if (system.column_of[j] >= 0) vertex.x[k] = x[system.column_of[j]];
    objective += lp.objective[j] * vertex.x[k];
  }
  vertex.duals = LongVector::Zero(lp.num_rows());
  for (std::size_t i = 0; i < lp.row_lower.size(); ++i) {
    const int row = system.row_of[i];
    if (row >= 0) vertex.duals[i] = y[row];
  }
  solution.objective = static_cast<double>(objective);
  solution.x = vertex.x.cast<double>();
  solution.duals = vertex.duals.cast<double>();
  solution.primal_error = primal_error(lp, vertex.x);
  solution.dual_error = dual_error(lp, basis, vertex.duals);
  return vertex;
}

LinearProgram magnified(const LinearProgram& lp, const LpVertex& vertex) {
  LinearProgram rest = lp;
  const long double primal = magnification(vertex.solution.primal_error);
  const long double dual = magnification(vertex.solution.dual_error);
  const auto shift = [&](const LongVector& origin, std::vector<double>* bounds) {
    for (std::size_t i = 0; i < bounds->size(); ++i) {
      (*bounds)[i] = static_cast<double>(primal * ((*bounds)[i] - origin[i]));
    }
  };
  for (auto* bounds : {&rest.lower, &rest.upper}) shift(vertex.x, bounds);
  const LongVector rows = activities(lp, vertex.x);
  for (auto* bounds : {&rest.row_lower, &rest.row_upper}) shift(rows, bounds);
  const LongVector reduced = dual * reduced_costs(lp, vertex.duals);
  Eigen::Map<Eigen::VectorXd>(rest.objective.data(), rest.num_variables()) = reduced.cast<double>();
  return rest;
}

}  // namespace graspless::mechanics
