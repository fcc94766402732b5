// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The only file that calls GLPK.
#include "mechanics/lp/glpk.hpp"

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <exception>
#include <utility>

#include <glpk.h>

#include "graspless/watch.hpp"

namespace graspless::mechanics {
namespace {

constexpr int kProgress = 5;  // between two lines of progress [ms]

/// Frees this thread's GLPK memory when the thread ends.
struct Environment {
  Environment() { glp_init_env(); }
  ~Environment() { glp_free_env(); }
};

/// The point to which GLPK's callbacks leave its calls.
struct Exit {
  std::jmp_buf jump;
  std::exception_ptr stopped;  // thrown by poll(); none after a fatal error
};

extern "C" void graspless_on_glpk_error(void* exit) {
  std::longjmp(static_cast<Exit*>(exit)->jump, 1);  // returning would abort
}

/// Called for each line that GLPK would print, which a long simplex does every kProgress.
extern "C" int graspless_on_glpk_output(void* info, const char* /*line*/) {
  constexpr int kPrinted = 1;
  auto* exit = static_cast<Exit*>(info);
  try {
    poll();
    return kPrinted;
  } catch (...) {  // must not pass through C
    exit->stopped = std::current_exception();
  }
  std::longjmp(exit->jump, 1);
}

/// Data exchanged with GLPK. It is plain, since a fatal error jumps out of the calls without
/// running destructors. Indices start at 1, as in GLPK.
struct Exchange {
  int rows, columns, entries;
  const int *entry_row, *entry_column;
  const double* entry_value;
  const double *row_lower, *row_upper, *lower, *upper, *objective;
  glp_smcp options;
  bool has_start, scaled;
  int code, status, primal_status;
  int *row_status, *column_status;
};

int bound_type(double lower, double upper) {
  const bool below = std::isfinite(lower), above = std::isfinite(upper);
  if (below && above) return lower == upper ? GLP_FX : GLP_DB;
  if (below) return GLP_LO;
  return above ? GLP_UP : GLP_FR;
}

void load(const Exchange& exchange, glp_prob* problem) {
  glp_set_obj_dir(problem, GLP_MAX);
  if (exchange.rows > 0) glp_add_rows(problem, exchange.rows);
  if (exchange.columns > 0) glp_add_cols(problem, exchange.columns);
  for (int i = 0; i < exchange.rows; ++i) {
    const double lower = exchange.row_lower[i], upper = exchange.row_upper[i];
    glp_set_row_bnds(problem, i + 1, bound_type(lower, upper), lower, upper);
  }
  for (int j = 0; j < exchange.columns; ++j) {
    const double lower = exchange.lower[j], upper = exchange.upper[j];
    glp_set_col_bnds(problem, j + 1, bound_type(lower, upper), lower, upper);
    glp_set_obj_coef(problem, j + 1, exchange.objective[j]);
  }
  glp_load_matrix(problem, exchange.entries, exchange.entry_row, exchange.entry_column,
                  exchange.entry_value);
  if (exchange.scaled) glp_scale_prob(problem, GLP_SF_AUTO);
  if (!exchange.has_start) return;
  for (int i = 0; i < exchange.rows; ++i) {
    glp_set_row_stat(problem, i + 1, exchange.row_status[i]);
  }
  for (int j = 0; j < exchange.columns; ++j) {
    glp_set_col_stat(problem, j + 1, exchange.column_status[j]);
  }
}

void run(Exchange* exchange) {
  glp_prob* problem = glp_create_prob();
  load(*exchange, problem);
  exchange->code = glp_simplex(problem, &exchange->options);
  if (exchange->code == 0 && glp_get_status(problem) != GLP_OPT &&
      glp_get_prim_stat(problem) != GLP_NOFEAS && glp_get_status(problem) != GLP_UNBND) {
    // There is no dual solution. The primal method distinguishes infeasible from unbounded.
    exchange->options.meth = GLP_PRIMAL;
    exchange->code = glp_simplex(problem, &exchange->options);
  }
  exchange->status = glp_get_status(problem);
  exchange->primal_status = glp_get_prim_stat(problem);
  for (int i = 0; i < exchange->rows; ++i) {
    exchange->row_status[i] = glp_get_row_stat(problem, i + 1);
  }
  for (int j = 0; j < exchange->columns; ++j) {
    exchange->column_status[j] = glp_get_col_stat(problem, j + 1);
  }
  glp_delete_prob(problem);
}

/// Returns false if GLPK met a fatal error. Throws what poll() throws.
bool run_guarded(Exchange* exchange) {
  static thread_local Environment environment;
  static_cast<void>(environment);
  static thread_local Exit exit;
  if (setjmp(exit.jump) != 0) {
    glp_free_env();  // also removes the hooks, and frees what the call left behind
    glp_init_env();
    if (exit.stopped) std::rethrow_exception(std::exchange(exit.stopped, nullptr));
    return false;
  }
  glp_error_hook(graspless_on_glpk_error, &exit);
  glp_term_hook(graspless_on_glpk_output, &exit);
  run(exchange);
  glp_term_hook(nullptr, nullptr);
  glp_error_hook(nullptr, nullptr);
  return true;
}

glp_smcp options(const LinearProgram& lp, const GlpkMethod& method) {
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_ON;  // for the hook alone, which prints nothing
  options.out_dly = options.out_frq = kProgress;
  options.meth = method.dual ? GLP_DUAL : GLP_PRIMAL;
  options.presolve = GLP_OFF;  // with the primal method it gave wrong optima
  options.tol_bnd = options.tol_dj = method.tolerance;
  // Far more than any of our programs needs; it stops a method that cycles.
  options.it_lim = 1000 + 2 * static_cast<int>(lp.num_rows() + lp.num_variables());
  return options;
}

BasisStatus status_of(int glpk) {
  switch (glpk) {
    case GLP_NL:
      return BasisStatus::at_lower;
    case GLP_NU:
      return BasisStatus::at_upper;
    case GLP_NF:
      return BasisStatus::free;
    case GLP_NS:
      return BasisStatus::fixed;
    default:
      return BasisStatus::basic;
  }
}

int glpk_of(BasisStatus status) {
  switch (status) {
    case BasisStatus::at_lower:
      return GLP_NL;
    case BasisStatus::at_upper:
      return GLP_NU;
    case BasisStatus::free:
      return GLP_NF;
    case BasisStatus::fixed:
      return GLP_NS;
    default:
      return GLP_BS;
  }
}

std::vector<BasisStatus> statuses(const std::vector<int>& glpk) {
  std::vector<BasisStatus> result(glpk.size());
  std::transform(glpk.begin(), glpk.end(), result.begin(), status_of);
  return result;
}

}  // namespace

bool find_basis(const LinearProgram& lp, const GlpkMethod& method, LpBasis* basis) {
  std::vector<int> entry_row(1), entry_column(1);
  std::vector<double> entry_value(1);
  for (const auto& entry : lp.entries) {
    entry_row.push_back(entry.row() + 1);
    entry_column.push_back(entry.col() + 1);
    entry_value.push_back(entry.value());
  }
  std::vector<int> rows(lp.row_lower.size()), columns(lp.lower.size());
  const bool has_start = basis->rows.size() == rows.size() && !basis->variables.empty();
  if (has_start) {
    std::transform(basis->rows.begin(), basis->rows.end(), rows.begin(), glpk_of);
    std::transform(basis->variables.begin(), basis->variables.end(), columns.begin(), glpk_of);
  }
  Exchange exchange{static_cast<int>(rows.size()),
                    static_cast<int>(columns.size()),
                    static_cast<int>(lp.entries.size()),
                    entry_row.data(),
                    entry_column.data(),
                    entry_value.data(),
                    lp.row_lower.data(),
                    lp.row_upper.data(),
                    lp.lower.data(),
                    lp.upper.data(),
                    lp.objective.data(),
                    options(lp, method),
                    has_start,
                    method.scaled,
                    0,
                    0,
                    0,
                    rows.data(),
                    columns.data()};
  if (!run_guarded(&exchange) || exchange.code != 0) return false;
  if (exchange.status == GLP_OPT) {
    basis->status = LpStatus::optimal;
  } else if (exchange.primal_status == GLP_NOFEAS) {
    basis->status = LpStatus::infeasible;
  } else if (exchange.status == GLP_UNBND) {
    basis->status = LpStatus::unbounded;
  } else {
    return false;
  }
  basis->rows = statuses(rows);
  basis->variables = statuses(columns);
  return true;
}

}  // namespace graspless::mechanics
