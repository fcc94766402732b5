// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/obstacle.hpp"
#include "graspless/collision/world.hpp"

#include "conversions.hpp"

namespace graspless::bindings {
namespace {

using collision::World;
using Shapes = std::vector<geometry::PlacedShape>;

void bind_obstacle(py::module_& m) {
  using collision::Obstacle;
  py::class_<Obstacle>(m, "Obstacle", "Fixed body that a motion must avoid.")
      .def(py::init([](const std::string& name, const Shapes& shapes, const Array& X_WB,
                       double padding) {
             Obstacle obstacle{name, shapes, to_pose(X_WB, "X_WB"), padding};
             collision::require_padding(obstacle, "padding of obstacle '" + name + "'");
             return obstacle;
           }),
           py::arg("name"), py::arg("shapes"), pose_arg("X_WB"), py::arg("padding") = 0.0,
           "shapes: PlacedShapes. X_WB: (4, 4) pose in the world. padding: distance that motions\n"
           "keep from the shapes [m].")
      .def_readonly("name", &Obstacle::name, "Name in errors.")
      .def_readonly("shapes", &Obstacle::shapes, "PlacedShapes in its frame B.")
      .def_property_readonly("X_WB", shown(&Obstacle::X_WB), "(4, 4) pose in the world.")
      .def_readonly("padding", &Obstacle::padding, "Distance that motions keep [m].")
      .def_property_readonly("grown_shapes", &Obstacle::grown,
                             "PlacedShapes that motions must not touch: `shapes`, grown by the "
                             "padding.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"name", "shapes", "X_WB", "padding"});
      });
}

}  // namespace

void bind_collision(py::module_ m) {
  bind_obstacle(m);
  py::class_<World>(
      m, "World",
      "Bodies at poses, and the pairs of them that must not touch. Independent of robots.\n\n"
      "A body is given by its name or its index. Not thread-safe: give each thread a copy.")
      .def(py::init<>(), "Creates a world without bodies.")
      .def(
          "__copy__", [](const World& self) { return World(self); },
          "Returns a copy that shares the shapes.")
      .def("add_body", py::overload_cast<const std::string&, const Shapes&>(&World::add_body),
           py::arg("name"), py::arg("shapes"),
           "Adds a body of one or more PlacedShapes at the identity pose. Returns its index.\n\n"
           "Raises ValueError on a bad shape or a name that is already taken.")
      .def_property_readonly("num_bodies", &World::num_bodies, "Number of bodies.")
      .def("body", &World::body, py::arg("name"),
           "Returns the index of a body.\n\nRaises ValueError that lists the bodies.")
      .def(
          "name",
          [](const World& self, const Key& body) { return self.name(body_index(self, body)); },
          py::arg("body"), "Returns the name of a body.")
      .def(
          "set_pose",
          [](World& self, const Key& body, const Array& X_WB) {
            self.set_pose(body_index(self, body), to_pose(X_WB, "X_WB"));
          },
          py::arg("body"), py::arg("X_WB"), "Moves a body to the pose X_WB, (4, 4), in the world.")
      .def(
          "pose",
          [](const World& self, const Key& body) {
            return from_pose(self.pose(body_index(self, body)));
          },
          py::arg("body"), "Returns the pose of a body in the world, (4, 4).")
      .def(
          "add_pair",
          [](World& self, const Key& a, const Key& b) {
            self.add_pair(body_index(self, a), body_index(self, b));
          },
          py::arg("a"), py::arg("b"), "Tests bodies a and b against each other from now on.")
      .def(
          "remove_pair",
          [](World& self, const Key& a, const Key& b) {
            self.remove_pair(body_index(self, a), body_index(self, b));
          },
          py::arg("a"), py::arg("b"), "Stops testing bodies a and b against each other.")
      .def(
          "allow_contact",
          [](World& self, const Key& a, const Key& b, const Array& normal_W, double depth) {
            self.allow_contact(body_index(self, a), body_index(self, b),
                               to_vector3(normal_W, "normal_W"), depth);
          },
          py::arg("a"), py::arg("b"), py::arg("normal_W"), py::arg("depth"),
          "Allows body a to press up to depth [m] into body b along -normal_W, (3,). A depth of 0 "
          "ends the allowance.\n\n"
          "Raises ValueError on a negative depth, a pair that is not tested, or a zero normal.")
      .def_property_readonly("pairs", &World::pairs, "Pairs of body indices that are tested.")
      .def("collides", &World::collides, "Returns True if any tested pair touches.")
      .def("first_collision", &World::first_collision,
           "Returns the first touching pair found, or None.")
      .def("all_collisions", &World::all_collisions, "Returns every touching pair.")
      .def(
          "distance_bounds", [](World& self) { return self.distance_bounds(); },
          "Returns a lower bound on the distance of each tested pair, in the order of pairs [m].")
      .def_property_readonly(
          "num_checks", &World::num_checks,
          "Number of configurations that collides() and first_collision() have tested so far.")
      .def("__repr__", [](const World& self) {
        return "<World of " + std::to_string(self.num_bodies()) + " bodies, " +
               std::to_string(self.pairs().size()) + " pairs tested>";
      });
}

}  // namespace graspless::bindings
