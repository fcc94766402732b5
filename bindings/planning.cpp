// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <optional>
#include <thread>

#include <pybind11/stl.h>

#include "graspless/watch.hpp"

#include "conversions.hpp"
#include "fields.hpp"

namespace graspless::bindings {
namespace {

constexpr double kLongest = 1e8;  // deadlines farther away are none [s]

/// The exception class; never destroyed, as Python may have ended by then.
py::object& out_of_time() {
  static auto* type = new py::object();
  return *type;
}

void bind_field_description(py::module_& m) {
  py::class_<FieldDescription>(m, "Field", "Description of an option or of a counter.")
      .def_readonly("name", &FieldDescription::name, "Name of the attribute.")
      .def_readonly("unit", &FieldDescription::unit, "Unit, such as \"m\"; may be empty.")
      .def_readonly("text", &FieldDescription::text, "Description in one or two sentences.")
      .def_readonly("range", &FieldDescription::range, "Interval of a number; may be empty.")
      .def_readonly("source", &FieldDescription::source,
                    "Symbol, section or equation of the planner's paper; may be empty.")
      .def_readonly("bounds", &FieldDescription::bounds,
                    "Bounds of a number under the names gt, ge, lt and le.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"name", "unit", "range", "text", "source"});
      });
}

/// Docstring of a field of the budget.
std::string doc_of(const std::string& name) {
  for (const FieldDescription& field : descriptions<planning::Budget>()) {
    if (field.name == name) {
      return field.text + (field.unit.empty() ? "" : "\n\nUnit: " + field.unit + ".");
    }
  }
  return "";
}

/// Returns the budget. Throws std::invalid_argument when a field is out of its range.
StoppableBudget checked(StoppableBudget budget) {
  planning::Clock{{budget.seconds, budget.iterations.value_or(0), budget.seed}};
  return budget;
}

using Steady = std::chrono::steady_clock;

thread_local std::optional<Steady::time_point> deadline;   // of work outside planners
thread_local std::optional<py::error_already_set> raised;  // what ended the work, for Python

/// Ends work for signals whose Python handler raises, and at the deadline.
void check_signals() {
  if (PyGILState_GetThisThreadState() == nullptr) return;  // not a thread of Python
  const py::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() == 0) {
    if (!deadline || Steady::now() < *deadline) return;
    deadline.reset();
    PyErr_SetString(out_of_time().ptr(), "the time limit was reached");
  }
  raised.emplace();
  throw Stop{};
}

/// Sleeps for a moment, during which other threads of Python run: one of them may be what this
/// thread waits for.
void sleep_without_gil() {
  std::optional<py::gil_scoped_release> release;
  if (PyGILState_GetThisThreadState() != nullptr && PyGILState_Check() != 0) release.emplace();
  std::this_thread::sleep_for(std::chrono::microseconds(100));
}

/// Translates Stop into what ended the work.
void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Stop&) {
    raised->restore();
    raised.reset();
  }
}

void bind_polling(py::module_& m) {
  out_of_time() = py::exception<Stop>(m, "OutOfTime", PyExc_BaseException);
  m.attr("OutOfTime").attr("__doc__") = "Raised where a deadline ends work outside planners.";
  set_default_check(check_signals);
  set_sleep(sleep_without_gil);
  py::register_exception_translator(translate);
  m.def(
      "set_deadline",
      [](std::optional<double> seconds) {
        deadline.reset();
        if (seconds && *seconds < kLongest) {
          const std::chrono::duration<double> wait(std::max(0.0, *seconds));
          deadline = Steady::now() + std::chrono::duration_cast<Steady::duration>(wait);
        }
      },
      py::arg("seconds"),
      "Makes work of this thread outside planners, such as reading a mesh, raise OutOfTime after "
      "so many seconds. None: no deadline.");
  m.def("poll", &poll, "Raises OutOfTime if this thread's deadline has passed.");
}

}  // namespace

void bind_planning(py::module_ m) {
  bind_field_description(m);
  bind_polling(m);
  py::class_<StoppableBudget>(m, "Budget",
                              "Limits of a query in time and iterations, and its random seed.")
      .def(py::init([](double seconds, std::optional<std::int64_t> iterations, std::uint64_t seed) {
             return checked({seconds, iterations, seed});
           }),
           py::kw_only(), py::arg("seconds") = 10.0, py::arg("iterations") = py::none(),
           py::arg("seed") = 1,
           "seconds: wall clock [s], above 0, may be inf. iterations: rounds of the main loop, "
           "None for no limit. seed: of all random numbers, from 0 to 2^64 - 1.\n\n"
           "The same seed and iterations give the same plan, bit by bit, unless the clock ends the "
           "search first.")
      .def_readonly("seconds", &StoppableBudget::seconds, doc_of("seconds").c_str())
      .def_readonly("iterations", &StoppableBudget::iterations, doc_of("iterations").c_str())
      .def_readonly("seed", &StoppableBudget::seed, doc_of("seed").c_str())
      .def_static("fields", &descriptions<planning::Budget>,
                  "Returns name, unit, range, text and source of every field.")
      .def(
          "part",
          [](const StoppableBudget& self, double seconds, std::uint64_t seed,
             std::optional<std::int64_t> iterations) {
            return checked({seconds, iterations ? iterations : self.iterations, seed,
                            self.stopped});  // stop() of either stops both
          },
          py::kw_only(), py::arg("seconds"), py::arg("seed"), py::arg("iterations") = py::none(),
          "Returns a budget for one part of a longer query, with its own seconds and seed.\n\n"
          "iterations: None for those of this budget. stop() of either stops both.")
      .def(
          "stop", [](StoppableBudget& self) { *self.stopped = true; },
          "Stops the search that uses this budget, from any thread. The search returns within "
          "about 10 ms; a task that is being read is read first.\n\n"
          "A stopped budget stays stopped: later searches that use it end at once.")
      .def_property_readonly(
          "is_stopped", [](const StoppableBudget& self) { return self.stopped->load(); },
          "True if stop() was called.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"seconds", "iterations", "seed"});
      });
}

}  // namespace graspless::bindings
