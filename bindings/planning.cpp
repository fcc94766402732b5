// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning.hpp"

#include <pybind11/stl.h>

#include "conversions.hpp"
#include "fields.hpp"

namespace graspless::bindings {
namespace {

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
    if (field.name == name) return field.text;
  }
  return "";
}

}  // namespace

void bind_planning(py::module_ m) {
  bind_field_description(m);
  py::class_<StoppableBudget>(m, "Budget",
                              "Limits of a query in time and iterations, and its random seed.")
      .def(py::init([](double seconds, std::optional<std::int64_t> iterations, std::uint64_t seed) {
             StoppableBudget budget{seconds, iterations, seed};
             planning::Budget checked;
             checked.seconds = seconds;
             checked.iterations = iterations.value_or(0);
             planning::Clock{checked};
             return budget;
           }),
           py::kw_only(), py::arg("seconds") = 10.0, py::arg("iterations") = py::none(),
           py::arg("seed") = 1,
           "seconds: wall clock [s], may be inf. iterations: rounds of the main loop, None for no "
           "limit.\n\n"
           "The same seed and iterations give the same plan, bit by bit, unless the clock ends the "
           "search first.")
      .def_readonly("seconds", &StoppableBudget::seconds, doc_of("seconds").c_str())
      .def_readonly("iterations", &StoppableBudget::iterations, doc_of("iterations").c_str())
      .def_readonly("seed", &StoppableBudget::seed, doc_of("seed").c_str())
      .def_static("fields", &descriptions<planning::Budget>,
                  "Returns name, unit, range, text and source of every field.")
      .def(
          "part",
          [](const StoppableBudget& self, double seconds, std::uint64_t seed) {
            StoppableBudget part = self;  // stop() of either stops both
            part.seconds = seconds;
            part.seed = seed;
            planning::Budget checked;
            checked.seconds = seconds;
            planning::Clock{checked};
            return part;
          },
          py::kw_only(), py::arg("seconds"), py::arg("seed"),
          "Returns a budget for one part of a longer query, with its own seconds and "
          "seed.\n\nstop() of either stops both.")
      .def(
          "stop", [](StoppableBudget& self) { *self.stopped = true; },
          "Stops the query that uses this budget, from any thread. The query returns within about "
          "10 ms.\n\n"
          "A stopped budget stays stopped: later queries that use it end at once.")
      .def_property_readonly(
          "is_stopped", [](const StoppableBudget& self) { return self.stopped->load(); },
          "True if stop() was called.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"seconds", "iterations", "seed"});
      });
}

}  // namespace graspless::bindings
