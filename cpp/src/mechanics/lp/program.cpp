// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Linear programs: input is validated before GLPK sees it, and its answers are checked.
#include "mechanics/lp/program.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "graspless/watch.hpp"

#include "mechanics/lp/basis.hpp"
#include "mechanics/lp/glpk.hpp"
#include "text.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kRounding = 1e-12;
constexpr double kSharpError = 1e-13;  // error below which nothing is refined
constexpr double kGoodError = 1e-10;   // error below which no other method is tried
constexpr double kBadError = 1e-6;     // error above which there is no answer
constexpr double kSharpTolerance = 1e-11;
constexpr int kMagnifications = 3;

void validate_bounds(const std::vector<double>& lower, const std::vector<double>& upper,
                     const std::string& what) {
  for (std::size_t i = 0; i < lower.size(); ++i) {
    // False for NaN. A lower bound of +infinity or an upper one of -infinity leaves nothing.
    if (lower[i] <= upper[i] && lower[i] < kInfinity && upper[i] > -kInfinity) continue;
    throw std::invalid_argument("bounds of " + what + " " + std::to_string(i) +
                                " must be ordered: " + figure(lower[i]) + ", " + figure(upper[i]));
  }
}

void validate_entries(const LinearProgram& lp) {
  const auto refuse = [](int row, int column, const std::string& what) {
    throw std::invalid_argument("entry (" + std::to_string(row) + ", " + std::to_string(column) +
                                ") must " + what);
  };
  std::vector<std::size_t> begin(lp.lower.size() + 1, 0);  // of the entries of each column
  for (const auto& entry : lp.entries) {
    const bool is_inside = entry.row() >= 0 && entry.row() < lp.num_rows() && entry.col() >= 0 &&
                           entry.col() < lp.num_variables();
    if (!is_inside) refuse(entry.row(), entry.col(), "lie in the matrix");
    if (!std::isfinite(entry.value())) refuse(entry.row(), entry.col(), "be finite");
    ++begin[static_cast<std::size_t>(entry.col()) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<int> rows(lp.entries.size());
  std::vector<std::size_t> next = begin;
  for (const auto& entry : lp.entries) rows[next[entry.col()]++] = entry.row();
  std::vector<int> last_column(lp.row_lower.size(), -1);  // with an entry in each row
  for (int column = 0; column < static_cast<int>(lp.lower.size()); ++column) {
    const auto at = static_cast<std::size_t>(column);
    for (std::size_t k = begin[at]; k < begin[at + 1]; ++k) {
      int& last = last_column[rows[k]];
      if (last == column) refuse(rows[k], column, "be given once");
      last = column;
    }
  }
}

void validate(const LinearProgram& lp) {
  validate_bounds(lp.lower, lp.upper, "variable");
  validate_bounds(lp.row_lower, lp.row_upper, "row");
  for (std::size_t j = 0; j < lp.objective.size(); ++j) {
    if (std::isfinite(lp.objective[j])) continue;
    throw std::invalid_argument("objective of variable " + std::to_string(j) + " must be finite");
  }
  validate_entries(lp);
}

double error(const LpSolution& solution) {
  return std::max(solution.primal_error, solution.dual_error);
}

bool is_good(const LpSolution& solution) {
  return solution.status == LpStatus::optimal && error(solution) <= kGoodError;
}

/// Returns the vertex that a method finds from a basis, refined (Gleixner, Steffy and Wolter 2012):
/// the method accepts errors up to its tolerance, so it finds a better basis for the program in
/// which they are magnified. Returns nothing if the method fails.
std::optional<LpVertex> solve_by(const GlpkMethod& method, const LinearProgram& lp,
                                 LpBasis basis = {}) {
  if (!find_basis(lp, method, &basis)) return std::nullopt;
  LpVertex best = vertex_of(lp, basis);
  for (int round = 0; round < kMagnifications; ++round) {
    if (error(best.solution) <= kSharpError || !std::isfinite(error(best.solution))) break;
    if (!find_basis(magnified(lp, best), method, &basis)) break;
    if (basis.status != LpStatus::optimal) break;
    LpVertex next = vertex_of(lp, basis);
    if (error(next.solution) >= error(best.solution)) break;
    best = std::move(next);
  }
  return best;
}

/// Phase one of the simplex method: the program of least violation of the rows. It has the
/// variables of `lp`, and then two for each row, which make up for what the row lacks.
LinearProgram phase_one(LinearProgram lp) {
  std::fill(lp.objective.begin(), lp.objective.end(), 0);
  for (int row = 0; row < static_cast<int>(lp.num_rows()); ++row) {
    lp.set(row, lp.add_variable(0, kInfinity, -1), 1);
    lp.set(row, lp.add_variable(0, kInfinity, -1), -1);
  }
  return lp;
}

/// Returns the basis of `lp` at a vertex of its phase one. A row whose addition is basic becomes
/// basic itself: their columns are the same but for the sign.
LpBasis of_phase_one(LpBasis basis, const LinearProgram& lp) {
  const std::size_t own = lp.lower.size();
  for (std::size_t j = own; j < basis.variables.size(); ++j) {
    if (basis.variables[j] == BasisStatus::basic) basis.rows[(j - own) / 2] = BasisStatus::basic;
  }
  basis.variables.resize(own);
  return basis;
}

/// Returns true if a vertex of phase one proves that the program is feasible; sets `basis` to it.
bool is_feasible(const LinearProgram& lp, LpBasis* basis) {
  const LinearProgram violation = phase_one(lp);
  if (!find_basis(violation, {false, kSharpTolerance}, basis)) return false;
  if (basis->status != LpStatus::optimal) return false;
  const LpSolution least = vertex_of(violation, *basis).solution;
  *basis = of_phase_one(std::move(*basis), lp);
  return error(least) <= kGoodError && least.objective >= -kSharpTolerance;
}

/// Returns the best answer of all methods, the first good one if there is any. A `start`, which
/// may be empty, is a feasible basis: no answer is then that the program is infeasible.
LpSolution best_answer(const LinearProgram& lp, const LpBasis& start) {
  // The dual method was right on every contact set tried. The others are for programs on which it
  // stalls.
  const std::array<GlpkMethod, 5> methods = {GlpkMethod{true, 1e-9}, GlpkMethod{false, 1e-9},
                                             GlpkMethod{true, 1e-7}, GlpkMethod{true, 1e-9, true},
                                             GlpkMethod{false, 1e-9, true}};
  LpSolution best;
  best.primal_error = kInfinity;
  for (const GlpkMethod& method : methods) {
    const auto vertex = solve_by(method, lp, start);
    if (!vertex) continue;
    const LpSolution& solution = vertex->solution;
    if (!start.rows.empty() && solution.status == LpStatus::infeasible) continue;
    if (error(solution) < error(best)) best = solution;
    if (error(best) <= kGoodError) break;
  }
  return best;
}

}  // namespace

int LinearProgram::add_variable(double variable_lower, double variable_upper, double coefficient) {
  lower.push_back(variable_lower);
  upper.push_back(variable_upper);
  objective.push_back(coefficient);
  return static_cast<int>(lower.size()) - 1;
}

int LinearProgram::add_row(double lower_bound, double upper_bound) {
  row_lower.push_back(lower_bound);
  row_upper.push_back(upper_bound);
  return static_cast<int>(row_lower.size()) - 1;
}

void LinearProgram::set(int row, int column, double value) {
  if (std::abs(value) < kRounding) return;
  entries.emplace_back(row, column, value);
}

void LinearProgram::set_block(int row, int column, const Eigen::Ref<const Eigen::MatrixXd>& block) {
  for (int j = 0; j < static_cast<int>(block.cols()); ++j) {
    for (int i = 0; i < static_cast<int>(block.rows()); ++i) set(row + i, column + j, block(i, j));
  }
}

LpSolution solve_lp(const LinearProgram& lp) {
  poll();
  validate(lp);
  LpSolution best = best_answer(lp, {});
  if (best.status == LpStatus::infeasible && error(best) <= kGoodError) {
    // The methods also say so of programs that are feasible within their tolerance only, and of
    // rows whose bounds are closer together than that. A vertex proves the opposite.
    const auto vertex = solve_by({false, kSharpTolerance}, lp);
    LpBasis start;
    if (vertex && is_good(vertex->solution)) {
      best = vertex->solution;
    } else if (is_feasible(lp, &start)) {
      best = best_answer(lp, start);
    }
  }
  if (error(best) > kBadError) {
    throw std::runtime_error(
        "the linear program could not be solved: the errors of the best answer are " +
        figure(error(best)));
  }
  return best;
}

LpSolution solve_lp(const LinearProgram& lp, LpBasis& basis) {
  const bool fits =
      basis.rows.size() == lp.row_lower.size() && basis.variables.size() == lp.lower.size();
  if (!fits) basis = {};
  poll();
  validate(lp);
  const auto vertex = solve_by({true, 1e-9}, lp, std::exchange(basis, {}));
  if (!vertex || !is_good(vertex->solution)) return solve_lp(lp);
  basis = vertex->basis;
  return vertex->solution;
}

}  // namespace graspless::mechanics
