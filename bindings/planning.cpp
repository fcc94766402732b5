// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning.hpp"

#include <pybind11/stl.h>

#include "conversions.hpp"

namespace graspless::bindings {

void bind_planning(py::module_ m) {
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
           "seconds: wall-clock limit [s], may be inf. iterations: limit on rounds of the main "
           "loop, None for no limit. seed: of all random numbers.\n\n"
           "The same seed and iterations give the same plan, bit by bit, unless time runs out "
           "first.\n\nRaises ValueError unless seconds is positive and iterations is not negative.")
      .def_readonly("seconds", &StoppableBudget::seconds, "Wall-clock limit [s].")
      .def_readonly("iterations", &StoppableBudget::iterations,
                    "Limit on rounds of the main loop; None for no limit.")
      .def_readonly("seed", &StoppableBudget::seed, "Seed of all random numbers.")
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
