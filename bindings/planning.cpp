// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning.hpp"

#include <pybind11/stl.h>

#include "conversions.hpp"

namespace graspless::bindings {

void bind_planning(py::module_ m) {
  py::class_<StoppableBudget>(m, "Budget", "All randomness and time of a query.")
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
      .def_readonly("seconds", &StoppableBudget::seconds, "Wall clock [s].")
      .def_readonly("iterations", &StoppableBudget::iterations,
                    "Rounds of the main loop; None for no limit.")
      .def_readonly("seed", &StoppableBudget::seed, "Of all random numbers.")
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
          "What a part of a longer query may spend: as this one, with seconds and seed of its "
          "own.\n\nstop() of either ends both.")
      .def(
          "stop", [](StoppableBudget& self) { *self.stopped = true; },
          "Ends the query that runs on this budget, from any thread; it returns within some 10 "
          "ms.\n\n"
          "A stopped budget stays so: later queries on it end at once.")
      .def_property_readonly(
          "is_stopped", [](const StoppableBudget& self) { return self.stopped->load(); },
          "Whether stop() was called.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"seconds", "iterations", "seed"});
      });
}

}  // namespace graspless::bindings
