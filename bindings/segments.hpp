// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "conversions.hpp"

namespace graspless::bindings {

/// Binds a Segment of joint motion without its constructor; `names` are what it may be called.
template <class Segment>
py::class_<Segment> bind_segment_class(
    py::module_& m, const char* names, const std::string& type = "Segment",
    const char* doc =
        "Part of a motion. No joint moves by more than 0.05 rad from one row to the next.") {
  py::class_<Segment> segment(m, type.c_str(), doc);
  segment.def_readonly("name", &Segment::name, names)
      .def_property_readonly("positions", shown(&Segment::positions),
                             "(N, dof) all joints [rad or m].")
      .def(
          "__len__", [](const Segment& self) { return self.positions.size(); }, "Number of rows.")
      .def("__repr__", [type](const Segment& self) {
        return "<" + type + " '" + self.name + "' of " + std::to_string(self.positions.size()) +
               " rows>";
      });
  return segment;
}

/// The segment. Throws std::invalid_argument unless it has as many `poses` as positions.
template <class Segment>
Segment with_equal_rows(Segment segment, Poses Segment::*poses, const std::string& name) {
  if (segment.positions.size() == (segment.*poses).size()) return segment;
  throw std::invalid_argument("segment '" + segment.name + "' has " +
                              std::to_string(segment.positions.size()) + " positions but " +
                              std::to_string((segment.*poses).size()) + " " + name);
}

/// Binds a planner's Segment with a pose of the object beside each row.
template <class Segment>
void bind_motion_segment(py::module_& m, const char* names) {
  bind_segment_class<Segment>(m, names)
      .def(py::init([](const std::string& name, const Array& positions, const Array& object_poses) {
             return with_equal_rows(Segment{name, to_configurations(positions, "positions"),
                                            to_poses(object_poses, "object_poses")},
                                    &Segment::object_poses, "object_poses");
           }),
           py::arg("name"), py::arg("positions"), py::arg("object_poses"),
           "positions: (N, dof) [rad or m]. object_poses: (N, 4, 4) poses of the object in the "
           "world.")
      .def_property_readonly("object_poses", shown(&Segment::object_poses),
                             "(N, 4, 4) pose of the object in the world at each row.");
}

}  // namespace graspless::bindings
