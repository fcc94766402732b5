// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/carry/carry.hpp"

#include "conversions.hpp"
#include "fields.hpp"
#include "planning.hpp"
#include "segments.hpp"

namespace graspless::bindings {
namespace {

using namespace carry;

using Normals = std::map<std::string, Array>;

std::vector<Rest> to_rests(const Normals& normals) {
  std::vector<Rest> rests;
  for (const auto& [obstacle, normal_W] : normals)
    rests.push_back({obstacle, to_vector3(normal_W, "rests_on[" + obstacle + "]")});
  return rests;
}

void bind_problem(py::module_& m) {
  py::class_<Problem>(
      m, "Problem",
      "Task of the planner: carry a held object along a straight path to another pose.")
      .def(py::init([](const robot::Robot& robot, const std::string& frame, const Obstacle& object,
                       const Array& X_WO_goal, const Array& q_start,
                       const std::vector<Obstacle>& obstacles, const Normals& rests_on,
                       const std::string& arm) {
             return Problem{robot,
                            arm,
                            frame,
                            object,
                            to_pose(X_WO_goal, "X_WO_goal"),
                            obstacles,
                            to_rests(rests_on),
                            to_configuration(robot, q_start, "q_start")};
           }),
           py::arg("robot"), py::arg("frame"), py::arg("object"), py::arg("X_WO_goal"),
           py::arg("q_start"), py::arg("obstacles") = std::vector<Obstacle>{},
           py::arg("rests_on") = Normals{}, py::arg("arm") = "arm",
           "frame: link that holds the object. object: its shapes, and its pose at the "
           "start.\nX_WO_goal: (4, 4) pose in the world at the end. q_start: (dof,) configuration "
           "at the start [rad or m]. rests_on: obstacles that\nthe object rests on at the start "
           "and may be dragged over, each with its unit normal (3,) in the world. arm: group of "
           "the joints that move.")
      .def_property_readonly(
          "robot", [](const Problem& self) { return self.robot; }, "Robot that moves.")
      .def_readonly("arm", &Problem::arm, "Group of the joints that move.")
      .def_readonly("frame", &Problem::frame, "Link that holds the object.")
      .def_readonly("object", &Problem::object, "Held object, with its pose at the start.")
      .def_property_readonly(
          "X_WO_goal", [](const Problem& self) { return from_pose(self.X_WO_goal); },
          "(4, 4) pose of the object in the world at the end.")
      .def_property_readonly(
          "q_start", [](const Problem& self) -> Eigen::VectorXd { return self.q_start; },
          "(dof,) configuration at the start [rad or m].")
      .def_readonly("obstacles", &Problem::obstacles,
                    "Bodies that neither the arm nor the object may touch.")
      .def_property_readonly(
          "rests_on",
          [](const Problem& self) {
            std::map<std::string, Eigen::Vector3d> normals;
            for (const Rest& rest : self.rests_on) normals[rest.obstacle] = rest.normal_W;
            return normals;
          },
          "Obstacles that the object rests on at the start, each with its unit normal (3,) in the "
          "world; a copy.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"robot", "arm", "frame", "object", "obstacles"});
      });
}

void bind_plan(py::module_& m) {
  py::class_<Plan> plan(m, "Plan", "Result of a query. False unless it is solved.");
  plan.def(py::init<>(), "A plan without segments, to be filled from a file.")
      .def(
          "__bool__", [](const Plan& self) { return static_cast<bool>(self); },
          "True if the query is solved.");
  const auto field = [&plan](const auto& described) { bind_field(plan, described); };
  field(Field{"status", &Plan::status, "Outcome of the query."});
  field(Field{"reason", &Plan::reason, "Explanation of the outcome in one sentence."});
  field(Field{"joint_names", &Plan::joint_names, "The robot's joints, in the order of positions."});
  field(Field{"segments", &Plan::segments, "Segments of the motion, in order."});
  field(Field{"reached", &Plan::reached, "Fraction of the path that was reached, in [0, 1]."});
  field(Field{"statistics", &Plan::statistics, "Counters of the search."});
  plan.def("__repr__", [](const py::object& self) {
    return represent(self, {"status", "reason", "segments"});
  });
}

}  // namespace

void bind_carry(py::module_ m) {
  bind_problem(m);
  bind_options_struct<Options>(m, "Options", "Options of the search.");
  bind_motion_segment<Segment>(m, "carry.");
  bind_statistics_struct<Statistics>(m);
  bind_choices<Status>(m, "Status", "Outcome of a query.");
  bind_plan(m);
  bind_front_door<Problem, Options, Plan>(
      m,
      "Plans a motion of the arm that carries the object along a straight path to its "
      "goal.\n\nFinding no plan is a status, not an error.",
      "Checks a plan against its problem by an independent replay.");
  bind_certify<Problem, Options, Plan>(
      m, "nothing touches that may not, and the object keeps to its straight path.");
}

}  // namespace graspless::bindings
