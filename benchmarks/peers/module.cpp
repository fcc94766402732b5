// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>

#include <Eigen/Core>
#include <ompl/config.h>
#include <pybind11/eigen.h>
#include <pybind11/native_enum.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "clasp_peers.hpp"
#include "planning.hpp"
#include "slide_peers.hpp"

namespace graspless::benchmarks {

namespace py = pybind11;
using bindings::run_interruptibly;
using bindings::StoppableBudget;

namespace {

void bind_grasp_rrt(py::module_& m) {
  py::class_<Grasp>(m, "Grasp", "Result of the Grasp-RRT. False unless it found a grasp.")
      .def(
          "__bool__", [](const Grasp& self) { return self.found; }, "True if a grasp was found.")
      .def_property_readonly(
          "q", [](const Grasp& self) -> Eigen::VectorXd { return self.q; },
          "(dof,) configuration with the hand closed [rad or m].")
      .def_readonly("quality", &Grasp::quality, "Epsilon of the contacts.")
      .def_property_readonly(
          "contacts",
          [](const Grasp& self) -> Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> {
            return self.p_OC.transpose();
          },
          "(N, 3) in O [m].")
      .def_readonly("linking", &Grasp::linking,
                    "Linking number of each closed finger curve with the loop that it is most "
                    "linked with.")
      .def_readonly("envelops", &Grasp::envelops, "True if a finger curve is linked with a loop.")
      .def_readonly("approaches", &Grasp::approaches, "Number of approaches that were tried.")
      .def_readonly("grasps", &Grasp::grasps, "Number of approaches that closed on the object.")
      .def_readonly("nodes", &Grasp::nodes, "Number of nodes of the tree.")
      .def_readonly("seconds", &Grasp::seconds, "Wall clock [s].")
      .def("__repr__", [](const py::object& self) {
        return py::str("Grasp(quality={0.quality}, envelops={0.envelops}, grasps={0.grasps})")
            .format(self);
      });
  m.def(
      "grasp_rrt",
      [](const clasp::Problem& problem, const StoppableBudget& budget) {
        return run_interruptibly(budget, [&](const planning::Budget& b) {
          return grasp_rrt(problem, GraspRrtOptions{}, b);
        });
      },
      py::arg("problem"), py::arg("budget"),
      "Runs a plain Grasp-RRT (Vahrenkamp, Asfour and Dillmann 2012). It knows contacts, and no "
      "loops.");
}

void bind_enums(py::module_& m) {
  py::native_enum<Peer>(m, "Peer", "enum.Enum", "Planners that the slide planner is compared with.")
      .value("forest", Peer::forest, "Ours, with nothing but the pair.")
      .value("cbirrt", Peer::cbirrt, "Algorithm 1 between one start and one goal.")
      .value("cbirrt2", Peer::cbirrt2, "Algorithm 1 from one start; goals are sampled.")
      .value("tangent_bundle_rrt_connect", Peer::tangent_bundle_rrt_connect, "OMPL's.")
      .value("projected_biest", Peer::projected_biest, "OMPL's.")
      .value("atlas_rrt_connect", Peer::atlas_rrt_connect, "OMPL's.")
      .value("projected_rrt_connect", Peer::projected_rrt_connect, "OMPL's.")
      .finalize();
  py::native_enum<PairDraw>(m, "PairDraw", "enum.Enum",
                            "Ways to draw the goal for a start that was drawn.")
      .value("independent", PairDraw::independent, "From C_g, until the pair is valid.")
      .value("fitting", PairDraw::fitting, "To fit the start, on its own branch.")
      .finalize();
}

void bind_pair_problem(py::module_& m) {
  py::class_<PairProblem>(m, "PairProblem",
                          "A slide problem with one start and one goal that make a valid pair.")
      .def(py::init<const slide::Problem&, const slide::Options&, PairDraw, std::uint64_t>(),
           py::arg("problem"), py::arg("options"), py::arg("draw"), py::arg("seed"),
           py::call_guard<py::gil_scoped_release>(),
           "Draws the pair. The same seed gives the same pair.")
      .def_property_readonly("has_pair", &PairProblem::has_pair, "True if a pair was found.")
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
          "Plans with a peer.\n\n"
          "Returns (plan, seconds): the peer's path with the pair's motions before and after, and "
          "the time that the peer alone took [s].")
      .def("is_valid", &PairProblem::is_valid, py::arg("arm"),
           "Returns True if the arm's joints keep the contact of the slide, and nothing collides.")
      .def("completed", &PairProblem::completed, py::arg("path"),
           "Returns the plan whose slide is a path of the arm's joints from start to goal. `path`: "
           "list of (arm dof,) [rad].")
      .def("__repr__", [](const py::object& self) {
        return py::str("PairProblem(has_pair={0.has_pair})").format(self);
      });
}

std::map<std::string, std::string> libraries() {
  const auto version = [](int major, int minor, int patch) {
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
  };
  return {
      {"ompl", version(OMPL_MAJOR_VERSION, OMPL_MINOR_VERSION, OMPL_PATCH_VERSION)},
      {"eigen", version(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"compiler", __VERSION__},
  };
}

}  // namespace

PYBIND11_MODULE(_peers, m) {
  m.doc() = "Planners that ours are compared with.";
  py::module_::import("graspless._core");  // which binds problems, plans and budgets
  bind_grasp_rrt(m);
  bind_enums(m);
  bind_pair_problem(m);
  m.def("libraries", &libraries, "Versions of the libraries and the compiler, by name.");
}

}  // namespace graspless::benchmarks
