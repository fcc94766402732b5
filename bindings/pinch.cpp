// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/pinch/pinch.hpp"

#include "conversions.hpp"
#include "fields.hpp"
#include "planning.hpp"
#include "segments.hpp"

namespace graspless::bindings {
namespace {

using namespace pinch;

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
  field(Field{"opening", &Plan::opening, "Distance between the fingers of the open hand [m]."});
  field(Field{"friction", &Plan::friction,
              "Coefficient of friction that the pinch needs: the tangent of the larger angle "
              "between the closing direction and the normal of a face."});
  field(Field{"max_mass", &Plan::max_mass,
              "Largest mass that the pads hold [kg]; None if nobody knows the force of the hand."});
  field(Field{"statistics", &Plan::statistics, "Counters of the search."});
  plan.def_property(
          "X_WH_grasp", [](const Plan& self) -> const Pose { return from_pose(self.X_WH_grasp); },
          [](Plan& self, const Array& X) { self.X_WH_grasp = to_pose(X, "X_WH_grasp"); },
          "(4, 4) pose of the grasp frame H in the world at the pinch.")
      .def_property(
          "contacts_O", [](const Plan& self) -> const Rows3 { return self.contacts_O.transpose(); },
          [](Plan& self, const Array& p) {
            self.contacts_O = p.size() == 0 ? Eigen::Matrix3Xd(3, 0) : to_points3(p, "contacts_O");
          },
          "(2, 3) contacts of the fingers in O [m]; (0, 3) unless solved.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"status", "reason", "segments"});
      });
}

}  // namespace

void bind_pinch(py::module_ m) {
  bind_options_struct<Options>(m, "Options", "Options of the search.");
  bind_motion_segment<Segment>(m, "approach, grasp or close.");
  bind_statistics_struct<Statistics>(m);
  bind_choices<Status>(m, "Status", "Outcome of a query.");
  bind_plan(m);
  bind_front_door<Problem, Options, Plan>(
      m,
      "Plans the motion: approach, grasp and close.\n\nFinding no plan is a status, not an error.",
      "Checks a plan against its problem by an independent replay.");
  bind_certify<Problem, Options, Plan>(m, "nothing touches that may not.");
}

}  // namespace graspless::bindings
