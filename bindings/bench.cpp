// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <ompl/config.h>
#include <pybind11/native_enum.h>

#include "conversions.hpp"
#include "planning.hpp"
#include "slide_peers.hpp"

namespace graspless::bindings {

using benchmarks::Answer;
using benchmarks::PairDraw;
using benchmarks::PairProblem;
using benchmarks::Peer;

void bind_bench(py::module_ m) {
  py::native_enum<Peer>(m, "Peer", "enum.Enum", "What the slide planner is measured against.")
      .value("forest", Peer::forest, "Ours, with nothing but the pair.")
      .value("cbirrt", Peer::cbirrt, "Algorithm 1 between one start and one goal.")
      .value("cbirrt2", Peer::cbirrt2, "Algorithm 1 from one start; goals are sampled.")
      .value("tangent_bundle_rrt_connect", Peer::tangent_bundle_rrt_connect, "OMPL's.")
      .value("projected_biest", Peer::projected_biest, "OMPL's.")
      .value("atlas_rrt_connect", Peer::atlas_rrt_connect, "OMPL's.")
      .value("projected_rrt_connect", Peer::projected_rrt_connect, "OMPL's.")
      .finalize();
  py::native_enum<PairDraw>(m, "PairDraw", "enum.Enum", "How a goal is found for a drawn start.")
      .value("independent", PairDraw::independent, "From C_g, until the pair is valid.")
      .value("fitting", PairDraw::fitting, "Drawn to fit the start, on its own branch.")
      .finalize();

  py::class_<PairProblem>(m, "PairProblem",
                          "A slide problem with one start and one goal that make a valid pair.")
      .def(py::init<const slide::Problem&, const slide::Options&, PairDraw, std::uint64_t>(),
           py::arg("problem"), py::arg("options"), py::arg("draw"), py::arg("seed"),
           py::call_guard<py::gil_scoped_release>(),
           "Draws the pair; the same seed gives the same.")
      .def_property_readonly("has_pair", &PairProblem::has_pair, "Whether a pair was found.")
      .def_property_readonly(
          "start", [](const PairProblem& self) -> Eigen::VectorXd { return self.start(); },
          "(arm dof,) [rad].")
      .def_property_readonly(
          "goal", [](const PairProblem& self) -> Eigen::VectorXd { return self.goal(); },
          "(arm dof,) [rad].")
      .def(
          "run",
          [](PairProblem& self, Peer peer, const StoppableBudget& budget) {
            return run_interruptibly(budget, [&](const planning::Budget& b) {
              Answer answer = self.run(peer, b);
              return std::pair(std::move(answer.plan), answer.seconds);
            });
          },
          py::arg("peer"), py::arg("budget"),
          "(plan, seconds): what the peer found, with the pair's motions before and after, and how "
          "long the peer alone took [s].")
      .def("__repr__", [](const py::object& self) { return represent(self, {"has_pair"}); });

  m.def(
      "libraries",
      [] {
        std::map<std::string, std::string> versions;
        versions["ompl"] = std::to_string(OMPL_MAJOR_VERSION) + "." +
                           std::to_string(OMPL_MINOR_VERSION) + "." +
                           std::to_string(OMPL_PATCH_VERSION);
        versions["eigen"] = std::to_string(EIGEN_WORLD_VERSION) + "." +
                            std::to_string(EIGEN_MAJOR_VERSION) + "." +
                            std::to_string(EIGEN_MINOR_VERSION);
        versions["compiler"] = __VERSION__;
        return versions;
      },
      "What this was built with, by name.");
}

}  // namespace graspless::bindings
