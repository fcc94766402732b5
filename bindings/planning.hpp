// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graspless/planning/budget.hpp"

#include "conversions.hpp"

namespace graspless::bindings {

/// planning::Budget with a stop flag that any Python thread may set.
struct StoppableBudget {
  double seconds = 10;
  std::optional<std::int64_t> iterations;
  std::uint64_t seed = 1;
  std::shared_ptr<std::atomic<bool>> stopped = std::make_shared<std::atomic<bool>>(false);
};

/// Runs `query(planning::Budget)` without the GIL. Budget.stop() and signals whose Python handler
/// raises (Ctrl-C) interrupt it. The exception of such a handler is thrown once the query has
/// returned.
template <class Query>
auto run_interruptibly(const StoppableBudget& given, const Query& query) {
  std::optional<py::error_already_set> raised;
  planning::Budget budget;
  budget.seconds = given.seconds;
  budget.iterations = given.iterations.value_or(budget.iterations);
  budget.seed = given.seed;
  budget.interrupted = [&raised, stopped = given.stopped] {
    if (*stopped) return true;
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) raised.emplace();
    return raised.has_value();
  };
  auto result = [&] {
    const py::gil_scoped_release release;
    return query(budget);
  }();
  if (raised) throw py::error_already_set(*raised);
  return result;
}

/// Binds the functions that every planner has, found in the namespace of Problem: validate() of a
/// problem and of options, plan() and check(). The planner gives the first sentences of the
/// docstrings of plan() and check().
template <class Problem, class Options, class Plan>
void bind_front_door(
    py::module_& m, const std::string& plan_doc, const std::string& check_doc,
    void (*validate_problem)(const Problem&) = [](const Problem& problem) { validate(problem); }) {
  const py::arg_v default_options("options", Options{}, "Options()");
  const py::arg_v default_budget("budget", StoppableBudget{}, "Budget()");
  m.def("validate", validate_problem, py::arg("problem"), py::call_guard<py::gil_scoped_release>(),
        "Raises ValueError that names the first bad field, its value and what is allowed.");
  m.def(
      "validate", [](const Options& options) { validate(options); }, py::arg("options"),
      "Raises ValueError that names the first bad option, its value and what is allowed.");
  m.def(
      "plan",
      [](const Problem& problem, const Options& options, const StoppableBudget& budget) {
        return run_interruptibly(budget, [&problem, options](const planning::Budget& b) {
          return plan(problem, options, b);
        });
      },
      py::arg("problem"), default_options, default_budget,
      (plan_doc + "\n\nReleases the GIL: other Python threads can run. Ctrl-C raises "
                  "KeyboardInterrupt; budget.stop() ends the query, which then returns the best "
                  "result so far.\n\nRaises ValueError on a bad problem or bad options.")
          .c_str());
  m.def(
      "check",
      [](const Problem& problem, const Plan& plan, const Options& options) {
        // Copied while the GIL is held: another thread may write to them meanwhile.
        const Plan plan_now = plan;
        const Options options_now = options;
        const py::gil_scoped_release release;
        return check(problem, plan_now, options_now);
      },
      py::arg("problem"), py::arg("plan"), default_options,
      (check_doc +
       "\n\nReturns one fault per entry, with segment and row; an empty list if the plan is valid.")
          .c_str());
}

/// Binds Plan: what all plans have, and more fields; its repr has those that are `shown`.
template <class Plan, class... Values>
py::class_<Plan> bind_plan_class(py::module_& m, const std::vector<const char*>& shown,
                                 const Field<Plan, Values>&... fields) {
  py::class_<Plan> plan(m, "Plan", "Result of a query. False unless it is solved.");
  plan.def(py::init<>(), "A plan without segments, to be filled from a file.")
      .def(
          "__bool__", [](const Plan& self) { return static_cast<bool>(self); },
          "True if the query is solved.")
      .def("__repr__", [shown](const py::object& self) { return represent(self, shown); });
  bind_field(plan, Field{"status", &Plan::status, "Outcome of the query."});
  bind_field(plan, Field{"reason", &Plan::reason, "Explanation of the outcome in one sentence."});
  bind_field(plan, Field{"statistics", &Plan::statistics, "Counters of the search."});
  (bind_field(plan, fields), ...);
  return plan;
}

/// Binds certify(), which the planners of joint paths have; `proven` says what it proves.
template <class Problem, class Options, class Plan>
void bind_certify(py::module_& m, const std::string& proven) {
  m.def(
      "certify",
      [](const Problem& problem, const Plan& plan, const Options& options) {
        const Plan plan_now = plan;
        const Options options_now = options;
        const py::gil_scoped_release release;
        return certify(problem, plan_now, options_now);
      },
      py::arg("problem"), py::arg("plan"), py::arg_v("options", Options{}, "Options()"),
      ("Proves what check() samples between the rows: " + proven +
       "\n\nReturns a scene.EdgeCertificate. Raises ValueError if the plan is not solved or "
       "malformed.")
          .c_str());
}

}  // namespace graspless::bindings
