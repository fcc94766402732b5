// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <ompl/config.h>
#include <pybind11/native_enum.h>

#include "clasp_peers.hpp"
#include "conversions.hpp"
#include "planning.hpp"
#include "slide_peers.hpp"

namespace graspless::bindings {

using benchmarks::Answer;
using benchmarks::Grasp;
using benchmarks::GraspRrtOptions;
using benchmarks::PairDraw;
using benchmarks::PairProblem;
using benchmarks::Peer;

namespace {

void bind_clasp_peers(py::module_& m) {
  py::class_<GraspRrtOptions> options(m, "GraspRrtOptions", "How the Grasp-RRT searches.");
  bind_fields(
      options, "Any field by keyword.",
      Field{"max_step", &GraspRrtOptions::max_step, "Of an extension, of any joint [rad]."},
      Field{"approach_probability", &GraspRrtOptions::approach_probability,
            "Share of the iterations that try to approach."},
      Field{"friction", &GraspRrtOptions::friction, "Of the contacts."},
      Field{"min_quality", &GraspRrtOptions::min_quality, "Of a grasp that is good enough."});
  py::class_<Grasp>(m, "Grasp", "What the Grasp-RRT found. False unless it found a grasp.")
      .def(
          "__bool__", [](const Grasp& self) { return self.found; }, "Whether it found one.")
      .def_property_readonly(
          "q", [](const Grasp& self) -> Eigen::VectorXd { return self.q; },
          "(dof,) the hand closed [rad or m].")
      .def_readonly("quality", &Grasp::quality, "Epsilon of the contacts.")
      .def_property_readonly(
          "contacts", [](const Grasp& self) -> Rows3 { return self.p_OC.transpose(); },
          "(N, 3) in O [m].")
      .def_readonly("linking", &Grasp::linking,
                    "Of every closed finger curve, with the loop that it is most linked with.")
      .def_readonly("envelops", &Grasp::envelops, "Some finger curve is linked with a loop.")
      .def_readonly("approaches", &Grasp::approaches, "Tried.")
      .def_readonly("grasps", &Grasp::grasps, "Of these, closed on something.")
      .def_readonly("nodes", &Grasp::nodes, "Of the tree.")
      .def_readonly("seconds", &Grasp::seconds, "Wall clock [s].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"quality", "envelops", "grasps"});
      });
  m.def(
      "grasp_rrt",
      [](const clasp::Problem& problem, const GraspRrtOptions& options,
         const StoppableBudget& budget) {
        return run_interruptibly(budget, [&](const planning::Budget& b) {
          return benchmarks::grasp_rrt(problem, options, b);
        });
      },
      py::arg("problem"), py::arg("options"), py::arg("budget"),
      "A plain Grasp-RRT (Vahrenkamp, Asfour and Dillmann 2012): it knows contacts, and no loops.");
}

}  // namespace

void bind_bench(py::module_ m) {
  bind_clasp_peers(m);
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
