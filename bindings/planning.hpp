// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include <pybind11/pybind11.h>

#include "graspless/planning/budget.hpp"

namespace graspless::bindings {

/// planning::Budget with a flag that another Python thread may raise.
struct StoppableBudget {
  double seconds = 10;
  std::optional<std::int64_t> iterations;
  std::uint64_t seed = 1;
  std::shared_ptr<std::atomic<bool>> stopped = std::make_shared<std::atomic<bool>>(false);
};

/// Runs `query(planning::Budget)` without the GIL. It is interrupted by Budget.stop() and by a
/// signal whose Python handler raises (Ctrl-C); what that raised is thrown once the query has
/// returned.
template <class Query>
auto run_interruptibly(const StoppableBudget& given, const Query& query) {
  namespace py = pybind11;
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

}  // namespace graspless::bindings
