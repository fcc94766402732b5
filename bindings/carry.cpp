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

void bind_places(py::module_& m) {
  py::class_<Places>(m, "Places", "Places on an obstacle where a held object may be put down.")
      .def(py::init([](const Array& X_WO, const std::string& on, const Array& q_open,
                       const Array& normal_W, const std::vector<Array>& way_out,
                       const Array& down_O) {
             Places places{to_poses(X_WO, "X_WO"), on, to_vector3(normal_W, "normal_W"),
                           to_vector(q_open, "q_open")};
             places.down_O = to_vector3(down_O, "down_O");
             for (const Array& q : way_out) places.way_out.push_back(to_vector(q, "way_out"));
             return places;
           }),
           py::arg("X_WO"), py::arg("on"), py::arg("q_open"),
           py::arg_v("normal_W", Array(py::cast(Eigen::Vector3d(0, 0, 1))), "(0, 0, 1)"),
           py::arg("way_out") = std::vector<Array>{},
           py::arg_v("down_O", Array(py::cast(Eigen::Vector3d(0, 0, 0))), "(0, 0, 0)"),
           "X_WO: (N, 4, 4) poses of the object in the world, the best first. on: obstacle on "
           "which it then stands. q_open: (dof,) configuration\nwhose joints outside the arm's "
           "group open the hand [rad or m]. normal_W: (3,) unit normal of the obstacle's surface "
           "in the world.\nway_out: (N, dof) configurations along which the hand can leave the "
           "object, the first with the hand open around it; it leaves it\nalong the same way "
           "relative to the object, with the same fingers. Without them, it goes straight. "
           "down_O: (3,) direction in O in which the object comes down; zero: against the normal.")
      .def_property_readonly("X_WO", shown(&Places::X_WO),
                             "(N, 4, 4) poses of the object in the world, the best first.")
      .def_readonly("on", &Places::on, "Obstacle on which the object then stands.")
      .def_property_readonly(
          "q_open", shown(&Places::q_open),
          "(dof,) configuration whose joints outside the arm's group open the hand [rad or m].")
      .def_readonly("way_out", &Places::way_out,
                    "List of (dof,) configurations along which the hand can leave the object [rad "
                    "or m]; empty: it goes straight.")
      .def_property_readonly(
          "down_O", shown(&Places::down_O),
          "(3,) direction in O in which the object comes down; zero: against the normal.")
      .def_property_readonly("normal_W", shown(&Places::normal_W),
                             "(3,) unit normal of the obstacle's surface in the world.")
      .def("__repr__", [](const Places& self) {
        return "<Places: " + std::to_string(self.X_WO.size()) + " on '" + self.on + "'>";
      });
}

void bind_problem(py::module_& m) {
  py::class_<Problem>(
      m, "Problem",
      "Task of the planner: carry a held object along a straight path to another pose, or put it "
      "down.")
      .def(py::init([](const robot::Robot& robot, const std::string& frame, const Obstacle& object,
                       const std::optional<Array>& X_WO_goal, const Array& q_start,
                       const std::vector<Obstacle>& obstacles, const Normals& rests_on,
                       const std::string& arm, const std::optional<Places>& places,
                       const std::optional<Array>& X_WO_hanging) {
             if (X_WO_goal.has_value() == places.has_value())
               throw std::invalid_argument("exactly one of X_WO_goal and places must be given");
             return Problem{
                 robot,
                 arm,
                 frame,
                 object,
                 X_WO_goal ? to_pose(*X_WO_goal, "X_WO_goal") : Eigen::Isometry3d::Identity(),
                 obstacles,
                 to_rests(rests_on),
                 to_configuration(robot, q_start, "q_start"),
                 places,
                 MaybePose::from(X_WO_hanging, "X_WO_hanging")};
           }),
           py::arg("robot"), py::arg("frame"), py::arg("object"), py::arg("X_WO_goal"),
           py::arg("q_start"), py::arg("obstacles") = std::vector<Obstacle>{},
           py::arg("rests_on") = Normals{}, py::arg("arm") = "arm",
           py::arg("places") = std::nullopt, py::arg("X_WO_hanging") = std::nullopt,
           "frame: link that holds the object. object: its shapes, and its pose at the "
           "start.\nX_WO_goal: (4, 4) pose in the world at the end. q_start: (dof,) configuration "
           "at the start [rad or m]. rests_on: obstacles that\nthe object rests on at the start "
           "and may be dragged over, each with its unit normal (3,) in the world. arm: group of "
           "the joints that move. places: where the object is put down; X_WO_goal is then None.\n"
           "X_WO_hanging: (4, 4) pose of a loose object at the start, as it hangs in the hand.")
      .def_property_readonly("robot", shown(&Problem::robot), "Robot that moves.")
      .def_readonly("arm", &Problem::arm, "Group of the joints that move.")
      .def_readonly("frame", &Problem::frame, "Link that holds the object.")
      .def_readonly("object", &Problem::object, "Held object, with its pose at the start.")
      .def_property_readonly(
          "X_WO_goal",
          [](const Problem& self) -> std::optional<const Pose> {
            if (self.places) return std::nullopt;
            return from_pose(self.X_WO_goal);
          },
          "(4, 4) pose of the object in the world at the end; None with places.")
      .def_readonly("places", &Problem::places, "Places where the object is put down, or None.")
      .def_property_readonly(
          "X_WO_hanging", shown(&Problem::X_WO_hanging),
          "(4, 4) pose of a loose object at the start, as it hangs in the hand; else None.")
      .def_property_readonly("q_start", shown(&Problem::q_start),
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
  bind_plan_class<Plan>(
      m, {"status", "reason", "segments"},
      Field{"joint_names", &Plan::joint_names, "The robot's joints, in the order of positions."},
      Field{"segments", &Plan::segments, "Segments of the motion, in order."},
      Field{"reached", &Plan::reached, "Fraction of the path that was reached, in [0, 1]."},
      Field{"place", &Plan::place, "Index of the place where the object is put down; -1: none."});
}

}  // namespace

void bind_carry(py::module_ m) {
  bind_places(m);
  bind_problem(m);
  bind_options_struct<Options>(m, "Options", "Options of the search.");
  bind_motion_segment<Segment>(m, "carry; with places transfer, lower, open or retreat.");
  bind_statistics_struct<Statistics>(m);
  bind_choices<Status>(m, "Status", "Outcome of a query.");
  bind_plan(m);
  bind_front_door<Problem, Options, Plan>(
      m,
      "Plans a motion of the arm that carries the object along a straight path to its goal, or "
      "puts it down at a place.\n\nFinding no plan is a status, not an error.",
      "Checks a plan against its problem by an independent replay.");
  bind_certify<Problem, Options, Plan>(
      m,
      "nothing touches that may not, and the object keeps to its straight path, or tilts no "
      "more than it may.");
}

}  // namespace graspless::bindings
