// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/pybind11.h>

namespace py = pybind11;

namespace graspless::bindings {
void bind_geometry(py::module_ m);
void bind_robot(py::module_ m);
void bind_collision(py::module_ m);
void bind_scene(py::module_ m);
void bind_planning(py::module_ m);
void bind_mechanics(py::module_ m);
void bind_slide(py::module_ m);
void bind_pinch(py::module_ m);
void bind_fingertip(py::module_ m);
void bind_clasp(py::module_ m);
void bind_carry(py::module_ m);
void bind_perception(py::module_ m);
}  // namespace graspless::bindings

// Table of contents, in dependency order: a signature names only classes already bound.
PYBIND11_MODULE(_core, m) {
  using namespace graspless::bindings;
  m.doc() = "The C++ core of graspless. Import its rooms from `graspless`, not from here.";
  bind_geometry(m.def_submodule("geometry",
                                "Shapes, supports, outlines, and the loops through the holes of a "
                                "cloud. Lengths in metres."));
  bind_robot(m.def_submodule("robot", "Robots read from URDF, and their inverse kinematics."));
  bind_collision(m.def_submodule("collision", "Bodies at poses, and tests whether they touch."));
  bind_scene(m.def_submodule("scene", "A robot among bodies."));
  bind_planning(m.def_submodule("planning", "Budget of a query, shared by all planners."));
  bind_mechanics(
      m.def_submodule("mechanics", "Stability of objects with frictional contacts (Maeda, Arai)."));
  bind_slide(
      m.def_submodule("slide", "Slide a thin object to the edge of its support and grasp it."));
  bind_pinch(m.def_submodule("pinch", "Pinch an object where it stands."));
  bind_fingertip(m.def_submodule(
      "fingertip", "Push, slide and tumble an object with bare fingertips (Maeda, Arai)."));
  bind_clasp(m.def_submodule(
      "clasp", "Put a hand through a hole of an object and close it (Stork, Pokorny, Kragic)."));
  bind_carry(m.def_submodule("carry", "Carry a held object along a straight path."));
  bind_perception(m.def_submodule(
      "perception", "Depth images: tables and objects in them, and images of known scenes."));
}
