// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "conversions.hpp"

namespace graspless::bindings {

/// A planner's Segment of joint motion with a pose of the object beside each row; `names` are what
/// it may be called.
template <class Segment>
void bind_motion_segment(pybind11::module_& m, const char* names) {
  namespace py = pybind11;
  py::class_<Segment>(
      m, "Segment",
      "Part of a motion. No joint moves by more than 0.05 rad from one row to the next.")
      .def(py::init([](const std::string& name, const Array& positions, const Array& object_poses) {
             Segment segment{name, to_configurations(positions, "positions"),
                             to_poses(object_poses, "object_poses")};
             if (segment.positions.size() != segment.object_poses.size()) {
               throw std::invalid_argument(
                   "segment '" + name + "' has " + std::to_string(segment.positions.size()) +
                   " positions but " + std::to_string(segment.object_poses.size()) +
                   " object_poses");
             }
             return segment;
           }),
           py::arg("name"), py::arg("positions"), py::arg("object_poses"),
           "positions: (N, dof) [rad or m]. object_poses: (N, 4, 4) poses of the object in the "
           "world.")
      .def_readonly("name", &Segment::name, names)
      .def_property_readonly(
          "positions",
          [](const Segment& self) -> const Rows {
            return from_configurations(self.positions,
                                       self.positions.empty() ? 0 : self.positions.front().size());
          },
          "(N, dof) all joints [rad or m].")
      .def_property_readonly("object_poses", shown(&Segment::object_poses),
                             "(N, 4, 4) pose of the object in the world at each row.")
      .def(
          "__len__", [](const Segment& self) { return self.positions.size(); }, "Number of rows.")
      .def("__repr__", [](const Segment& self) {
        return "<Segment '" + self.name + "' of " + std::to_string(self.positions.size()) +
               " rows>";
      });
}

}  // namespace graspless::bindings
