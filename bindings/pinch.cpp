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
  bind_plan_class<Plan>(
      m, {"status", "reason", "segments"},
      Field{"joint_names", &Plan::joint_names, "The robot's joints, in the order of positions."},
      Field{"segments", &Plan::segments, "Segments of the motion, in order."},
      Field{"opening", &Plan::opening, "Distance between the fingers of the open hand [m]."},
      Field{"friction", &Plan::friction,
            "Coefficient of friction that the pinch needs: the tangent of the larger angle "
            "between the closing direction and the normal of a face."},
      Field{"max_mass", &Plan::max_mass,
            "Largest mass that the pads hold [kg]; None if nobody knows the force of the hand."},
      Field{"X_WH_grasp", &Plan::X_WH_grasp,
            "(4, 4) pose of the grasp frame H in the world at the pinch."})
      .def_property(
          "contacts_O", shown(&Plan::contacts_O),
          [](Plan& self, const Array& p) {
            self.contacts_O = p.size() == 0 ? Eigen::Matrix3Xd(3, 0) : to_points3(p, "contacts_O");
          },
          "(2, 3) contacts of the fingers in O [m]; (0, 3) unless solved.");
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
      "Checks a plan against its problem by an independent replay.",
      [](const Problem& problem) { validate(problem, false); });
  bind_certify<Problem, Options, Plan>(m, "nothing touches that may not.");
}

}  // namespace graspless::bindings
